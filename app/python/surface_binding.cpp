// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/python/surface_binding.h"

#include "app/cli/metric_fill.h"
#include "app/cli/surface_words.h"
#include "app/python/arrays.h"
#include "app/python/json_binding.h"
#include "app/python/metric_binding.h"
#include "core/hierarchy/settings.h"
#include "core/io/io.h"
#include "core/surface/boundary_surface.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <cmath>
#include <optional>
#include <utility>

namespace ameco::python {
namespace {

/// The faces alone of a surface, or of the boundary of a mesh.
std::shared_ptr<const Mesh<3>> faces_of(AnyMesh& any, PythonMonitor& monitor) {
    const auto* const mesh = std::get_if<std::shared_ptr<const Mesh<3>>>(&any.mesh);
    if (mesh == nullptr) {
        throw UsageError("surface: is a mesh in two dimensions, and has no surface");
    }
    if ((*mesh)->elements.empty()) {
        return *mesh;
    }
    require_valid(any, monitor);
    return std::make_shared<const Mesh<3>>(boundary_surface(**mesh));
}

AnyMesh read_surface(const std::filesystem::path& path) {
    PythonMonitor monitor{py::none(), py::none()};
    AnyMesh result;
    result.mesh = monitor.call([&] {
        MeshFile file = read_mesh(path, {.surfaces = true});
        for (const std::string& change : file.changes) {
            monitor.message(Severity::warning, path.string() + ": " + change);
        }
        return std::make_shared<const Mesh<3>>(cli::surface_of(std::move(file), path, monitor));
    });
    return result;
}

double number_in(const char* argument, const py::handle& value, double low, double high) {
    const double number = py::float_(py::reinterpret_borrow<py::object>(value));
    if (!(number >= low && number <= high)) {
        throw UsageError(std::string(argument) + ": " + exact_word(number) +
                         " is not a number from " + exact_word(low) + " to " + exact_word(high));
    }
    return number;
}

std::vector<Vec<3>> points(const py::object& given, const char* argument) {
    const auto array = rows<double>(given, 3, argument);
    std::vector<Vec<3>> result;
    for (py::ssize_t i = 0; i < array.shape(0); ++i) {
        result.emplace_back(array.at(i, 0), array.at(i, 1), array.at(i, 2));
    }
    return result;
}

/// (point, id) or (point, id, size) each.
std::vector<RegionSeed> regions(const py::object& given) {
    std::vector<RegionSeed> seeds;
    for (const py::handle item : given) {
        const auto parts = py::cast<std::vector<py::object>>(item);
        if (parts.size() != 2 && parts.size() != 3) {
            throw UsageError("regions: must be a list of (point, id) or (point, id, size)");
        }
        RegionSeed seed;
        seed.inside =
            points(py::list(py::make_tuple(parts[0])), "regions: the points, as a list,").front();
        const double id = number_in("regions", parts[1], 1, 1e6);
        if (id != std::floor(id)) {
            throw UsageError("regions: " + exact_word(id) + " is not a whole number");
        }
        seed.region = static_cast<int>(id);
        if (parts.size() == 3) {
            seed.size = number_in("regions", parts[2], 0, 1e300);
        }
        seeds.push_back(seed);
    }
    return seeds;
}

FillOptions options_from_arguments(const py::dict& given) {
    FillOptions options;
    RecoveryOptions& recovery = options.recovery;
    const std::string boundary = py::str(given["boundary"]);
    if (boundary != "keep" && boundary != "split") {
        throw UsageError("boundary: " + boundary + " is not one of keep, split");
    }
    recovery.faces = boundary == "keep" ? GivenFaces::keep : GivenFaces::split;
    if (!given["size"].is_none()) {
        recovery.size = number_in("size", given["size"], 1e-300, 1e300);
    }
    recovery.radius_edge = number_in("radius_edge", given["radius_edge"], 0, 100);
    if (recovery.radius_edge > 0 && recovery.radius_edge < least_radius_edge) {
        throw UsageError("radius_edge: below 1.1 no end of refining is in sight");
    }
    recovery.holes = points(given["holes"], "holes");
    recovery.regions = regions(given["regions"]);
    if (!given["farfield"].is_none()) {
        options.farfield = farfield_from(std::string(py::str(given["farfield"])));
    }
    return options;
}

std::pair<AnyMesh, py::object> fill(AnyMesh& surface, const std::optional<AnyMetric>& metric,
                                    const py::dict& given, const py::object& progress,
                                    const py::object& cancel) {
    PythonMonitor monitor(progress, cancel);
    const FillOptions options = options_from_arguments(given);
    const double growth = number_in("growth", given["growth"], 0, 10);
    AnyMesh faces;
    faces.mesh = faces_of(surface, monitor);
    const auto& mesh = *std::get<std::shared_ptr<const Mesh<3>>>(faces.mesh);
    cli::MetricFill made = monitor.call([&] {
        MetricField<3> field;
        if (metric) {
            field = with_both(faces, *metric, []<int D>(const Mesh<D>&, const MetricField<D>& f) {
                if constexpr (D == 3) {
                    return f;
                } else {
                    return MetricField<3>();
                }
            });
        }
        return cli::fill_to_metric(mesh, field, growth, options, "surface", monitor);
    });
    const py::object report = python_value(cli::fill_json(made));
    AnyMesh result;
    result.mesh = std::make_shared<const Mesh<3>>(std::move(made.fill.mesh));
    result.known_valid = true;
    return {std::move(result), report};
}

} // namespace

void bind_surfaces(py::module_& module) {
    module.def("read_surface", &read_surface);
    module.def("fill", &fill);
}

} // namespace ameco::python
