// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/python/remesh_binding.h"

#include "app/python/json_binding.h"
#include "app/python/metric_binding.h"
#include "app/python/options_binding.h"
#include "core/adapt/adapt.h"
#include "core/adapt/metric_source.h"

#include <pybind11/stl.h>

#include <cmath>
#include <optional>
#include <tuple>

namespace ameco::python {
namespace {

/// What a word stands for. \throws UsageError that lists the words there are
template <class Choice, class Choices>
Choice chosen(const char* argument, const std::string& word, const Choices& choices) {
    std::string names;
    for (const Choice choice : choices) {
        if (name(choice) == word) {
            return choice;
        }
        names += (names.empty() ? "" : ", ") + std::string(name(choice));
    }
    throw UsageError(std::string(argument) + ": " + word + " is not one of " + names);
}

/// Arguments that `coarsen` does not have; they are taken out of `given`.
struct OwnArguments {
    AdaptOptions options;
    Mean interpolation = Mean::corrected;
};

OwnArguments take_own_arguments(py::dict& given) {
    const auto take = [&](const char* key) { return py::object(given.attr("pop")(key)); };
    OwnArguments own;
    own.interpolation =
        chosen<Mean>("interpolation", py::str(take("interpolation")), interpolating_means);
    own.options.engine = chosen<Engine>("engine", py::str(take("engine")), all_engines);
    if (const py::object quality = take("quality"); !quality.is_none()) {
        own.options.quality = chosen<Quality>("quality", py::str(quality), all_qualities);
    }
    own.options.node_nested = py::bool_(take("node_nested"));
    const py::object passes = take("passes");
    const int most = 1000;
    if (PyIndex_Check(passes.ptr()) == 0 || passes < py::int_(1) || py::int_(most) < passes) {
        throw UsageError("passes: " + std::string(py::str(passes)) +
                         " is not a whole number from 1 to " + std::to_string(most));
    }
    own.options.passes = passes.cast<int>();
    return own;
}

/// The metric that is given, or the same size everywhere.
AnyMetric wanted_metric(const AnyMesh& mesh, const std::optional<AnyMetric>& metric,
                        std::optional<double> size) {
    if (metric.has_value() == size.has_value()) {
        throw UsageError("remesh: takes a metric or a size, one of them");
    }
    if (metric) {
        return *metric;
    }
    if (!(*size > 0) || !std::isfinite(*size)) {
        throw UsageError("size: " + std::string(py::str(py::float_(*size))) +
                         " is not a number greater than 0");
    }
    return std::visit(
        [&]<int D>(const std::shared_ptr<const Mesh<D>>& m) -> AnyMetric {
            return {std::make_shared<const MetricField<D>>(
                isotropic_metric<D>(m->points.size(), *size))};
        },
        mesh.mesh);
}

std::tuple<AnyMesh, AnyMetric, py::object>
remesh(AnyMesh& mesh, const std::optional<AnyMetric>& metric, std::optional<double> size,
       py::dict given, const py::object& progress, const py::object& cancel) {
    PythonMonitor monitor(progress, cancel);
    OwnArguments own = take_own_arguments(given);
    const CoarsenOptions shared = options_from(given, mesh).coarsen;
    own.options.features = shared.features;
    own.options.surface = shared.removal.surface;
    const AnyMetric wanted = wanted_metric(mesh, metric, size);
    require_valid(mesh, monitor);
    AdaptReport report;
    AnyMesh result;
    const AnyMetric result_metric = monitor.call([&] {
        return with_both(mesh, wanted, [&]<int D>(const Mesh<D>& m, const MetricField<D>& field) {
            const BackgroundMetric<D> source(m, field, own.interpolation);
            Adapted<D> adapted = adapt(m, source, own.options, report, monitor);
            result.mesh = std::make_shared<const Mesh<D>>(std::move(adapted.mesh));
            return AnyMetric{std::make_shared<const MetricField<D>>(std::move(adapted.metric))};
        });
    });
    result.known_valid = true;
    return {std::move(result), result_metric, python_value(to_json(report))};
}

} // namespace

void bind_remesh(py::module_& module) {
    module.def("remesh", &remesh);
}

} // namespace ameco::python
