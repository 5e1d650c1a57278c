// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/python/errors.h"

#include "core/base/error.h"

#include <string>
#include <utility>

namespace ameco::python {
namespace {

namespace py = pybind11;

/// The exceptions, for the translator, which is a plain function. They live as long as the process.
struct Types {
    PyObject* error = nullptr;
    PyObject* file = nullptr;
    PyObject* input = nullptr;
    PyObject* usage = nullptr;
    PyObject* not_converged = nullptr;
    PyObject* check_failed = nullptr;
    PyObject* cancelled = nullptr;
};
Types types;

PyObject* add_type(py::module_& module, const char* name, const char* doc, const py::tuple& bases,
                   ExitCode code) {
    py::dict members;
    members["exit_code"] = static_cast<int>(code);
    members["__module__"] = "ameco";
    const std::string full_name = std::string("ameco.") + name;
    PyObject* const type =
        PyErr_NewExceptionWithDoc(full_name.c_str(), doc, bases.ptr(), members.ptr());
    if (type == nullptr) {
        throw py::error_already_set();
    }
    module.add_object(name, py::reinterpret_borrow<py::object>(type));
    return type;
}

PyObject* type_of(const Error& e) {
    if (dynamic_cast<const FileError*>(&e) != nullptr) {
        return types.file;
    }
    if (dynamic_cast<const InputError*>(&e) != nullptr) {
        return types.input;
    }
    if (dynamic_cast<const UsageError*>(&e) != nullptr) {
        return types.usage;
    }
    if (dynamic_cast<const NotConverged*>(&e) != nullptr) {
        return types.not_converged;
    }
    if (dynamic_cast<const CheckFailed*>(&e) != nullptr) {
        return types.check_failed;
    }
    if (dynamic_cast<const Cancelled*>(&e) != nullptr) {
        return types.cancelled;
    }
    return types.error;
}

void translate(std::exception_ptr pointer) {
    try {
        std::rethrow_exception(std::move(pointer));
    } catch (const Error& e) {
        PyObject* const type = type_of(e);
        const py::object instance = py::reinterpret_borrow<py::object>(type)(e.what());
        instance.attr("exit_code") = static_cast<int>(e.code());
        PyErr_SetObject(type, instance.ptr());
    }
}

} // namespace

void bind_errors(py::module_& module) {
    const py::handle exception = PyExc_Exception;
    types.error = add_type(module, "Error",
                           "Trouble from outside: a file, an option, a mesh, a request to stop.",
                           py::make_tuple(exception), ExitCode::internal);
    const py::handle error = types.error;
    const auto add = [&](const char* name, const char* doc, PyObject* beside, ExitCode code) {
        return add_type(module, name, doc, py::make_tuple(error, py::handle(beside)), code);
    };
    types.file = add("FileError", "A file cannot be opened, read or written.", PyExc_OSError,
                     ExitCode::file);
    types.input = add("InputError", "A mesh or metric is not usable.", PyExc_ValueError,
                      ExitCode::invalid_input);
    types.usage =
        add("UsageError", "An argument makes no sense.", PyExc_ValueError, ExitCode::usage);
    types.not_converged = add("NotConverged", "An iteration that was chosen does not converge.",
                              PyExc_RuntimeError, ExitCode::check_failed);
    types.check_failed =
        add("CheckFailed", "What was made is not what it must be, and is not delivered.",
            PyExc_RuntimeError, ExitCode::check_failed);
    types.cancelled = add_type(module, "Cancelled", "The computation was asked to stop.",
                               py::make_tuple(error), ExitCode::cancelled);
    py::register_exception_translator(&translate);
}

} // namespace ameco::python
