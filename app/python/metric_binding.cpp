// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/python/metric_binding.h"

#include "app/python/arrays.h"
#include "app/python/json_binding.h"
#include "app/python/mesh_binding.h"
#include "app/python/options_binding.h"
#include "core/coarsen/target_metric.h"
#include "core/io/io.h"
#include "core/metric/complexity.h"
#include "core/metric/conformity.h"
#include "core/metric/nodal_metric.h"

#include <pybind11/stl/filesystem.h>

#include <utility>

namespace ameco::python {
namespace {

namespace fs = std::filesystem;

/// The sizes, or the directions, of all nodes where they are.
template <int D>
py::array sizes(const MetricField<D>& field, std::shared_ptr<const void> owner) {
    const auto n = static_cast<py::ssize_t>(field.size());
    return view(field.empty() ? nullptr : field.data()->sizes.data(), {n, D},
                {sizeof(Metric<D>), sizeof(double)}, std::move(owner));
}

template <int D>
py::array directions(const MetricField<D>& field, std::shared_ptr<const void> owner) {
    const auto n = static_cast<py::ssize_t>(field.size());
    // Eigen stores columns one after another.
    return view(field.empty() ? nullptr : field.data()->directions.data(), {n, D, D},
                {sizeof(Metric<D>), sizeof(double), D * sizeof(double)}, std::move(owner));
}

template <int D>
py::array tensors(const MetricField<D>& field) {
    auto owner = std::make_shared<IdVector<NodeId, Tensor<D>>>();
    {
        const py::gil_scoped_release unlocked;
        owner->reserve(field.size());
        for (const Metric<D>& metric : field) {
            owner->push_back(to_tensor<D>(metric));
        }
    }
    return view_of<double, tensor_size<D>>(*owner, owner);
}

template <int D>
AnyMetric from_rows(const py::array_t<double, py::array::c_style>& array) {
    MetricField<D> field;
    field.reserve(static_cast<std::size_t>(array.shape(0)));
    for (py::ssize_t i = 0; i < array.shape(0); ++i) {
        Tensor<D> tensor{};
        std::copy_n(array.data(i, 0), tensor.size(), tensor.begin());
        const Metric<D> metric = from_tensor<D>(tensor);
        if (!is_valid(metric)) {
            throw InputError("tensor " + std::to_string(i) + " is not positive definite");
        }
        field.push_back(metric);
    }
    return {std::make_shared<const MetricField<D>>(std::move(field))};
}

AnyMetric metric_from_tensors(const py::object& given) {
    const py::array array = py::module_::import("numpy").attr("asarray")(given);
    if (array.ndim() == 2 && array.shape(1) == tensor_size<2>) {
        return from_rows<2>(rows<double>(array, tensor_size<2>, "tensors"));
    }
    if (array.ndim() == 2 && array.shape(1) == tensor_size<3>) {
        return from_rows<3>(rows<double>(array, tensor_size<3>, "tensors"));
    }
    throw UsageError("tensors: must be an array of shape (n, 3): xx xy yy, or (n, 6): "
                     "xx xy xz yy yz zz");
}

AnyMetric read_metric_file(const fs::path& path) {
    PythonMonitor monitor{py::none(), py::none()};
    MetricFile file = monitor.call([&] { return read_metric(path); });
    for (const std::string& note : file.notes) {
        monitor.message(Severity::info, path.string() + ": " + note);
    }
    return std::visit(
        []<int D>(MetricField<D>& field) -> AnyMetric {
            return {std::make_shared<const MetricField<D>>(std::move(field))};
        },
        file.field);
}

AnyMetric natural_metric(AnyMesh& mesh, const py::dict& options, const py::object& progress,
                         const py::object& cancel) {
    const Mean mean = options_from(options, mesh).coarsen.mean;
    PythonMonitor monitor(progress, cancel);
    require_valid(mesh, monitor);
    return monitor.call([&] {
        return std::visit(
            [&]<int D>(const std::shared_ptr<const Mesh<D>>& m) -> AnyMetric {
                return {std::make_shared<const MetricField<D>>(nodal_metric(*m, mean, monitor))};
            },
            mesh.mesh);
    });
}

AnyMetric coarser_metric(AnyMesh& mesh, const AnyMetric& natural, const py::dict& options) {
    const TargetOptions target = options_from(options, mesh).coarsen.target;
    PythonMonitor monitor{py::none(), py::none()};
    require_valid(mesh, monitor);
    return monitor.call([&] {
        return with_both(mesh, natural, [&]<int D>(const Mesh<D>& m, const MetricField<D>& field) {
            return AnyMetric{
                std::make_shared<const MetricField<D>>(target_metric(m, field, target))};
        });
    });
}

py::object conformity_of(AnyMesh& mesh, const AnyMetric& metric) {
    PythonMonitor monitor{py::none(), py::none()};
    require_valid(mesh, monitor);
    const Conformity measured = monitor.call([&] {
        return with_both(mesh, metric,
                         [](const auto& m, const auto& field) { return conformity(m, field); });
    });
    return python_value(to_json(measured));
}

double complexity_of(AnyMesh& mesh, const AnyMetric& metric) {
    PythonMonitor monitor{py::none(), py::none()};
    require_valid(mesh, monitor);
    return monitor.call([&] {
        return with_both(mesh, metric,
                         [](const auto& m, const auto& field) { return complexity(m, field); });
    });
}

void write(const AnyMetric& metric, const fs::path& path) {
    const py::gil_scoped_release unlocked;
    std::visit([&](const auto& field) { write_metric(path, *field); }, metric.field);
}

std::size_t size_of(const AnyMetric& metric) {
    return std::visit([](const auto& field) { return field->size(); }, metric.field);
}

} // namespace

void bind_metric(py::module_& module) {
    py::class_<AnyMetric>(module, "MetricField")
        .def(py::init(&metric_from_tensors), py::arg("tensors"))
        .def_property_readonly("sizes",
                               [](const AnyMetric& metric) {
                                   return std::visit([](const auto& f) { return sizes(*f, f); },
                                                     metric.field);
                               })
        .def_property_readonly(
            "directions",
            [](const AnyMetric& metric) {
                return std::visit([](const auto& f) { return directions(*f, f); }, metric.field);
            })
        .def_property_readonly("tensors",
                               [](const AnyMetric& metric) {
                                   return std::visit([](const auto& f) { return tensors(*f); },
                                                     metric.field);
                               })
        .def_property_readonly("aspect_ratio",
                               [](const AnyMetric& metric) -> py::object {
                                   const py::object h = py::cast(metric).attr("sizes");
                                   const auto column = [&](int i) {
                                       return h[py::make_tuple(py::ellipsis(), i)];
                                   };
                                   return py::object(column(-1)) / py::object(column(0));
                               })
        .def("write", &write, py::arg("path"))
        .def("__len__", &size_of)
        .def("__repr__", [](const AnyMetric& metric) {
            return "<ameco.MetricField: " + std::to_string(size_of(metric)) + " tensors>";
        });
    module.def("read_metric", &read_metric_file);
    module.def("natural_metric", &natural_metric);
    module.def("target_metric", &coarser_metric);
    module.def("conformity", &conformity_of);
    module.def("complexity", &complexity_of);
}

} // namespace ameco::python
