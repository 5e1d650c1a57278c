// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/python/options_binding.h"

#include "app/cli/mesh_input.h"
#include "app/python/mesh_binding.h"
#include "core/base/error.h"
#include "core/hierarchy/settings.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>

namespace ameco::python {
namespace {

/// A value as the word that the command line takes.
std::string word_of(const Setting& s, const py::handle& value) {
    if (value.is_none() && s.zero_is_off) {
        return "0";
    }
    if (s.kind == Setting::Kind::flag) {
        return PyObject_IsTrue(value.ptr()) == 1 ? "1" : "0";
    }
    if (py::isinstance<py::str>(value) || PyIndex_Check(value.ptr()) != 0) {
        return py::str(value);
    }
    return PyNumber_Check(value.ptr()) != 0
               ? exact_word(py::float_(py::reinterpret_borrow<py::object>(value)))
               : std::string(py::repr(value));
}

double checked_factor(const py::handle& value) {
    const double factor = py::float_(py::reinterpret_borrow<py::object>(value));
    if (!(factor > 1) || !std::isfinite(factor)) {
        throw UsageError("factor: " + exact_word(factor) + " is not a number greater than 1");
    }
    return factor;
}

/// As `--factor`: one for all levels, or one per level.
void assign_factors(HierarchyOptions& options, const py::handle& value) {
    if (!py::isinstance<py::sequence>(value)) {
        options.coarsen.target.factor = checked_factor(value);
        return;
    }
    std::vector<double> factors;
    for (const py::handle item : value) {
        factors.push_back(checked_factor(item));
    }
    if (factors.empty()) {
        throw UsageError("factor: an empty list");
    }
    options.coarsen.target.factor = factors.front();
    if (factors.size() > 1) {
        options.factors = std::move(factors);
    }
}

std::vector<int> patches(const AnyMesh& mesh, const py::handle& value) {
    if (py::isinstance<py::str>(value)) {
        throw UsageError("freeze: must be a list of patches, ids or names");
    }
    std::vector<std::string> words;
    for (const py::handle item : value) {
        words.push_back(py::str(item));
    }
    return std::visit([&](const auto& m) { return cli::find_patches(*m, "freeze", words); },
                      mesh.mesh);
}

py::dict row_of(const Setting& s) {
    const HierarchyOptions defaults;
    py::dict row;
    row["help"] = s.help;
    row["accepts"] = s.wanted();
    const std::string word = s.value(defaults);
    switch (s.kind) {
    case Setting::Kind::flag:
        row["default"] = word == "1";
        break;
    case Setting::Kind::whole_number:
        row["default"] = std::stoi(word);
        break;
    case Setting::Kind::choice:
        row["default"] = word;
        break;
    case Setting::Kind::number:
        row["default"] = s.zero_is_off && word == "0" ? py::object(py::none())
                                                      : py::object(py::float_(std::stod(word)));
        break;
    }
    return row;
}

py::dict settings_table() {
    py::dict table;
    for (const Setting& s : settings()) {
        std::string key(s.name);
        std::replace(key.begin(), key.end(), '-', '_');
        table[py::str(key)] = row_of(s);
    }
    return table;
}

} // namespace

HierarchyOptions options_from(const py::dict& given, const AnyMesh& mesh) {
    HierarchyOptions options;
    for (const auto& [key, value] : given) {
        std::string name = py::str(key);
        std::replace(name.begin(), name.end(), '_', '-');
        if (name == "factor") {
            assign_factors(options, value);
        } else if (name == "freeze") {
            options.coarsen.features.frozen_patches = patches(mesh, value);
        } else {
            const Setting& s = setting(name);
            const std::string word = word_of(s, value);
            if (!s.accepts(word)) {
                throw UsageError(std::string(py::str(key)) + ": " + word + " is not " + s.wanted());
            }
            s.assign(options, word);
        }
    }
    const HierarchyOptions defaults;
    if (options.target_ratio > 0 &&
        (!options.factors.empty() ||
         options.coarsen.target.factor != defaults.coarsen.target.factor)) {
        throw UsageError("factor: excluded by target_ratio, which chooses it");
    }
    return options;
}

void bind_options(py::module_& module) {
    module.def("settings", &settings_table);
}

} // namespace ameco::python
