// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Typed indices, and arrays that accept only their own kind of index.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace ameco {

/// A 32-bit index that knows what it counts. A default-made id means "none".
template <class Tag>
class Id {
public:
    constexpr Id() = default;
    constexpr explicit Id(std::int32_t value) : value_(value) {}
    constexpr explicit Id(std::size_t value) : value_(static_cast<std::int32_t>(value)) {}

    [[nodiscard]] constexpr std::int32_t value() const { return value_; }
    [[nodiscard]] constexpr std::size_t index() const { return static_cast<std::size_t>(value_); }
    [[nodiscard]] constexpr bool valid() const { return value_ >= 0; }

    friend constexpr auto operator<=>(Id, Id) = default;

private:
    std::int32_t value_ = -1;
};

using NodeId = Id<struct NodeTag>;
using ElementId = Id<struct ElementTag>;
using FaceId = Id<struct FaceTag>;

/// A std::vector that is indexed by one kind of id only.
template <class I, class T>
class IdVector {
public:
    /// The ids 0 ... size-1, for range-based loops.
    class Ids {
    public:
        class Iterator {
        public:
            explicit Iterator(std::size_t i) : i_(i) {}
            I operator*() const { return I(i_); }
            Iterator& operator++() {
                ++i_;
                return *this;
            }
            friend bool operator==(Iterator, Iterator) = default;

        private:
            std::size_t i_;
        };
        explicit Ids(std::size_t n) : n_(n) {}
        [[nodiscard]] Iterator begin() const { return Iterator(0); }
        [[nodiscard]] Iterator end() const { return Iterator(n_); }

    private:
        std::size_t n_;
    };

    IdVector() = default;
    explicit IdVector(std::size_t n, const T& value = T()) : data_(n, value) {}
    explicit IdVector(std::vector<T> data) : data_(std::move(data)) {}

    [[nodiscard]] T& operator[](I id) { return data_[id.index()]; }
    [[nodiscard]] const T& operator[](I id) const { return data_[id.index()]; }
    [[nodiscard]] std::size_t size() const { return data_.size(); }
    [[nodiscard]] bool empty() const { return data_.empty(); }
    [[nodiscard]] bool contains(I id) const { return id.valid() && id.index() < data_.size(); }
    [[nodiscard]] Ids ids() const { return Ids(data_.size()); }
    [[nodiscard]] T* data() { return data_.data(); }
    [[nodiscard]] const T* data() const { return data_.data(); }
    [[nodiscard]] auto begin() { return data_.begin(); }
    [[nodiscard]] auto end() { return data_.end(); }
    [[nodiscard]] auto begin() const { return data_.begin(); }
    [[nodiscard]] auto end() const { return data_.end(); }
    /// The plain array underneath, for algorithms and file readers.
    [[nodiscard]] std::vector<T>& raw() { return data_; }
    [[nodiscard]] const std::vector<T>& raw() const { return data_; }
    [[nodiscard]] I next_id() const { return I(data_.size()); }

    void push_back(T value) { data_.push_back(std::move(value)); }
    void pop_back() { data_.pop_back(); }
    void resize(std::size_t n, const T& value = T()) { data_.resize(n, value); }
    void reserve(std::size_t n) { data_.reserve(n); }
    void assign(std::size_t n, const T& value) { data_.assign(n, value); }
    void clear() { data_.clear(); }

    friend bool operator==(const IdVector&, const IdVector&) = default;

private:
    std::vector<T> data_;
};

} // namespace ameco
