// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Core's arrays as NumPy's, without a copy; NumPy's as core's, with one.
#pragma once

#include "core/base/error.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <limits>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace ameco::python {

namespace py = pybind11;

/// An array that looks at memory of `owner`, which lives as long as the array does. It cannot be
/// written to: others look at the same memory, perhaps while they compute.
/// \param strides  in bytes; empty for rows one after another
template <class T>
[[nodiscard]] py::array view(const T* data, const std::vector<py::ssize_t>& shape,
                             const std::vector<py::ssize_t>& strides,
                             std::shared_ptr<const void> owner) {
    using Owner = std::shared_ptr<const void>;
    const py::capsule keep(new Owner(std::move(owner)),
                           [](void* memory) { delete static_cast<Owner*>(memory); });
    py::array_t<T> array = strides.empty() ? py::array_t<T>(shape, data, keep)
                                           : py::array_t<T>(shape, strides, data, keep);
    array.attr("setflags")(py::arg("write") = false);
    return array;
}

/// The same of a vector whose items are `Width` numbers of type T each, one after another: [n] for
/// a width of 1, else [n, Width].
template <class T, std::size_t Width, class Vector>
[[nodiscard]] py::array view_of(const Vector& values, std::shared_ptr<const void> owner) {
    using Item = std::remove_cv_t<std::remove_reference_t<decltype(*values.data())>>;
    static_assert(sizeof(Item) == Width * sizeof(T));
    const auto n = static_cast<py::ssize_t>(values.size());
    std::vector<py::ssize_t> shape{n};
    if (Width > 1) {
        shape.push_back(static_cast<py::ssize_t>(Width));
    }
    return view(reinterpret_cast<const T*>(values.data()), shape, {}, std::move(owner));
}

/// Rows of `width` numbers each from whatever NumPy takes for an array; a width of 0 is one row.
/// \param name  of the argument, for messages
/// \throws UsageError for another shape, and for numbers that are not whole where they must be
template <class T>
[[nodiscard]] py::array_t<T, py::array::c_style> rows(const py::object& given, py::ssize_t width,
                                                      const std::string& name) {
    const py::module_ numpy = py::module_::import("numpy");
    py::array array = numpy.attr("asarray")(given);
    const std::string shape = width > 0 ? "(n, " + std::to_string(width) + ")" : "(n,)";
    if (array.size() == 0) {
        std::vector<py::ssize_t> none(width > 0 ? 2 : 1, 0);
        none.back() = width;
        return py::array_t<T, py::array::c_style>(none);
    }
    if (array.ndim() != (width > 0 ? 2 : 1) || (width > 0 && array.shape(1) != width)) {
        throw UsageError(name + ": must be an array of shape " + shape);
    }
    const char kind = array.dtype().kind();
    if constexpr (std::is_integral_v<T>) {
        if (kind != 'i' && kind != 'u') {
            throw UsageError(name + ": must be an array of whole numbers");
        }
        const auto largest = py::int_(std::numeric_limits<T>::max());
        const auto smallest = py::int_(std::numeric_limits<T>::min());
        if (largest < py::int_(array.attr("max")()) || py::int_(array.attr("min")()) < smallest) {
            throw UsageError(name + ": has a number that does not fit into 32 bits");
        }
    } else if (kind != 'f' && kind != 'i' && kind != 'u') {
        throw UsageError(name + ": must be an array of numbers");
    }
    return py::array_t<T, py::array::c_style | py::array::forcecast>(array);
}

} // namespace ameco::python
