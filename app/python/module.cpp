// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The compiled part of the Python package `ameco`. What users call is in ameco/__init__.py, which
/// gives these functions their signatures.
#include "app/python/errors.h"
#include "app/python/level_binding.h"
#include "app/python/mesh_binding.h"
#include "app/python/metric_binding.h"
#include "app/python/options_binding.h"
#include "app/python/remesh_binding.h"
#include "app/python/surface_binding.h"
#include "app/python/transfer_binding.h"
#include "core/base/parallel.h"
#include "core/cases/cases.h"

#include <pybind11/stl.h>

#include <map>
#include <string>

namespace ameco::python {
namespace {

std::map<std::string, std::string> case_summaries() {
    std::map<std::string, std::string> result;
    for (const CaseDescription& description : cases()) {
        result[description.name] = description.summary;
    }
    return result;
}

} // namespace
} // namespace ameco::python

PYBIND11_MODULE(_core, module) {
    using namespace ameco::python;
    module.attr("version") = AMECO_VERSION;
    bind_errors(module);
    bind_options(module);
    bind_mesh(module);
    bind_metric(module);
    bind_levels(module);
    bind_remesh(module);
    bind_surfaces(module);
    bind_transfer(module);
    module.def("cases", &case_summaries);
    module.def("set_threads", &ameco::set_thread_count);
    module.def("threads", &ameco::thread_count);
}
