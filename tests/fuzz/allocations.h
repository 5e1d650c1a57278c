// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What a piece of code asks operator new for. Include in one file of a program: it replaces the
/// global operators.
#pragma once

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <new>

#include <malloc.h>

namespace ameco::test {

/// What operator new was asked for since the last `reset`.
struct Allocations {
    std::atomic<std::int64_t> live{0};
    std::atomic<std::int64_t> peak{0};
    std::atomic<std::int64_t> largest{0};

    void reset() {
        peak = live.load();
        largest = 0;
    }
};
inline Allocations allocations;

inline void raise_to(std::atomic<std::int64_t>& maximum, std::int64_t value) {
    std::int64_t seen = maximum.load();
    while (value > seen && !maximum.compare_exchange_weak(seen, value)) {
    }
}

inline void* counted_allocation(std::size_t bytes, std::size_t alignment) {
    void* p = alignment == 0
                  ? std::malloc(bytes == 0 ? 1 : bytes)
                  : std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
    if (!p) {
        throw std::bad_alloc();
    }
    const auto usable = static_cast<std::int64_t>(malloc_usable_size(p));
    raise_to(allocations.largest, static_cast<std::int64_t>(bytes));
    raise_to(allocations.peak, allocations.live += usable);
    return p;
}

inline void counted_release(void* p) {
    if (p) {
        allocations.live -= static_cast<std::int64_t>(malloc_usable_size(p));
        std::free(p);
    }
}

} // namespace ameco::test

void* operator new(std::size_t bytes) {
    return ameco::test::counted_allocation(bytes, 0);
}
void* operator new[](std::size_t bytes) {
    return ameco::test::counted_allocation(bytes, 0);
}
void* operator new(std::size_t bytes, std::align_val_t a) {
    return ameco::test::counted_allocation(bytes, static_cast<std::size_t>(a));
}
void* operator new[](std::size_t bytes, std::align_val_t a) {
    return ameco::test::counted_allocation(bytes, static_cast<std::size_t>(a));
}
void* operator new(std::size_t bytes, const std::nothrow_t&) noexcept {
    return ameco::test::counted_allocation(bytes, 0);
}
void* operator new[](std::size_t bytes, const std::nothrow_t&) noexcept {
    return ameco::test::counted_allocation(bytes, 0);
}
void operator delete(void* p) noexcept {
    ameco::test::counted_release(p);
}
void operator delete[](void* p) noexcept {
    ameco::test::counted_release(p);
}
void operator delete(void* p, std::size_t) noexcept {
    ameco::test::counted_release(p);
}
void operator delete[](void* p, std::size_t) noexcept {
    ameco::test::counted_release(p);
}
void operator delete(void* p, std::align_val_t) noexcept {
    ameco::test::counted_release(p);
}
void operator delete[](void* p, std::align_val_t) noexcept {
    ameco::test::counted_release(p);
}
void operator delete(void* p, std::size_t, std::align_val_t) noexcept {
    ameco::test::counted_release(p);
}
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept {
    ameco::test::counted_release(p);
}
