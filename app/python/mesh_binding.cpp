// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/python/mesh_binding.h"

#include "app/python/arrays.h"
#include "core/cases/cases.h"
#include "core/io/io.h"
#include "core/mesh/boundary.h"
#include "core/mesh/check.h"
#include "core/remesh/geometry_classes.h"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <utility>

namespace ameco::python {
namespace {

namespace fs = std::filesystem;

template <class T, std::size_t Width, class Vector>
void assign(Vector& values, const py::object& given, const char* name) {
    if (given.is_none()) {
        return;
    }
    const auto array = rows<T>(given, Width > 1 ? static_cast<py::ssize_t>(Width) : 0, name);
    const auto n = static_cast<std::size_t>(array.shape(0));
    if constexpr (std::is_same_v<T, double>) {
        values.assign(n, Vec<Width>::Zero()); // Eigen's own default is no value at all
    } else {
        values.resize(n);
    }
    if (array.nbytes() > 0) {
        std::memcpy(static_cast<void*>(values.data()), array.data(),
                    static_cast<std::size_t>(array.nbytes()));
    }
}

void require_length(std::size_t length, std::size_t wanted, const char* name, const char* things) {
    if (length != wanted) {
        throw UsageError(std::string(name) + ": has " + std::to_string(length) + " numbers for " +
                         std::to_string(wanted) + " " + things);
    }
}

/// Brings a mesh to the conventions of mesh.h and shares it.
template <int D>
AnyMesh shared(Mesh<D>&& mesh, bool repair, double ridge_angle_deg) {
    AnyMesh result;
    if (repair) {
        result.repairs = repair_remarks(complete_boundary(mesh, ridge_angle_deg));
    }
    result.mesh = std::make_shared<const Mesh<D>>(std::move(mesh));
    return result;
}

void assign_features(Features& features, const py::dict& given) {
    const auto get = [&](const char* name) -> py::object { return given[name]; };
    assign<int, 2>(features.edges, get("edges"), "edges");
    assign<int, 1>(features.edge_labels, get("edge_labels"), "edge_labels");
    if (get("edge_labels").is_none()) {
        features.edge_labels.assign(features.edges.size(), 0);
    }
    require_length(features.edge_labels.size(), features.edges.size(), "edge_labels", "edges");
    assign<int, 1>(features.corners, get("corners"), "corners");
    assign<int, 1>(features.ridges, get("ridges"), "ridges");
    assign<int, 1>(features.required_nodes, get("required_nodes"), "required_nodes");
    assign<int, 1>(features.required_edges, get("required_edges"), "required_edges");
    assign<int, 1>(features.required_faces, get("required_faces"), "required_faces");
    assign<int, 1>(features.required_elements, get("required_elements"), "required_elements");
}

template <int D>
AnyMesh mesh_from_arrays(const py::dict& given, bool repair, double ridge_angle_deg) {
    Mesh<D> mesh;
    const auto get = [&](const char* name) -> py::object { return given[name]; };
    assign<double, D>(mesh.points, get("nodes"), "nodes");
    assign<int, D + 1>(mesh.elements, get("elements"), "elements");
    assign<int, D>(mesh.faces, get("faces"), "faces");
    mesh.region.assign(mesh.elements.size(), 0);
    assign<int, 1>(mesh.region, get("regions"), "regions");
    mesh.patch.assign(mesh.faces.size(), 1);
    assign<int, 1>(mesh.patch, get("patches"), "patches");
    assign<int, 1>(mesh.labels, get("labels"), "labels");
    require_length(mesh.region.size(), mesh.elements.size(), "regions", "elements");
    require_length(mesh.patch.size(), mesh.faces.size(), "patches", "faces");
    if (!mesh.labels.empty()) {
        require_length(mesh.labels.size(), mesh.points.size(), "labels", "nodes");
    }
    mesh.patch_names = given["patch_names"].cast<std::map<int, std::string>>();
    assign_features(mesh.features, given);
    const py::gil_scoped_release unlocked;
    return shared(std::move(mesh), repair, ridge_angle_deg);
}

AnyMesh make_mesh(const py::dict& given, bool repair, double ridge_angle_deg) {
    const py::object nodes = py::module_::import("numpy").attr("asarray")(given["nodes"]);
    const auto shape = nodes.attr("shape").cast<std::vector<py::ssize_t>>();
    if (shape.size() != 2 || (shape[1] != 2 && shape[1] != 3)) {
        throw UsageError("nodes: must be an array of shape (n, 2) or (n, 3)");
    }
    return shape[1] == 3 ? mesh_from_arrays<3>(given, repair, ridge_angle_deg)
                         : mesh_from_arrays<2>(given, repair, ridge_angle_deg);
}

AnyMesh read(const fs::path& path, bool repair, double ridge_angle_deg) {
    PythonMonitor monitor{py::none(), py::none()};
    MeshFile file = monitor.call([&] { return read_mesh(path); });
    for (const std::string& change : file.changes) {
        monitor.message(Severity::warning, path.string() + ": " + change);
    }
    for (const std::string& note : file.notes) {
        monitor.message(Severity::info, path.string() + ": " + note);
    }
    return monitor.call([&] {
        return std::visit(
            [&](auto& mesh) { return shared(std::move(mesh), repair, ridge_angle_deg); },
            file.mesh);
    });
}

AnyMesh make_case_mesh(const std::string& name,
                       const std::map<std::string, std::string>& parameters) {
    const py::gil_scoped_release unlocked;
    auto made = make_case(name, parameters);
    return std::visit([](auto& mesh) { return shared(std::move(mesh), false, 0); }, made);
}

void write(const AnyMesh& mesh, const fs::path& path, const std::string& format) {
    PythonMonitor monitor{py::none(), py::none()};
    const auto notes = monitor.call([&] {
        WriteOptions options;
        options.format = format;
        return std::visit([&](const auto& m) { return write_mesh(path, *m, options); }, mesh.mesh);
    });
    for (const std::string& note : notes) {
        monitor.message(Severity::warning, path.string() + ": " + note);
    }
}

/// A property that looks at an array of the mesh.
template <class Look>
auto array_of(Look look) {
    return [look](const AnyMesh& mesh) {
        return std::visit([&](const auto& m) -> py::array { return look(*m, m); }, mesh.mesh);
    };
}

void bind_arrays(py::class_<AnyMesh>& type) {
    type.def_property_readonly("nodes", array_of([]<int D>(const Mesh<D>& m, auto owner) {
                                   return view_of<double, D>(m.points, owner);
                               }));
    type.def_property_readonly("elements", array_of([]<int D>(const Mesh<D>& m, auto owner) {
                                   return view_of<int, D + 1>(m.elements, owner);
                               }));
    type.def_property_readonly("faces", array_of([]<int D>(const Mesh<D>& m, auto owner) {
                                   return view_of<int, D>(m.faces, owner);
                               }));
    const auto numbers = [&](const char* name, auto member) {
        type.def_property_readonly(name, array_of([member](const auto& m, auto owner) {
                                       return view_of<int, 1>(member(m), owner);
                                   }));
    };
    numbers(
        "regions", [](const auto& m) -> auto& { return m.region; });
    numbers(
        "patches", [](const auto& m) -> auto& { return m.patch; });
    numbers(
        "labels", [](const auto& m) -> auto& { return m.labels; });
    type.def_property_readonly("edges", array_of([](const auto& m, auto owner) {
                                   return view_of<int, 2>(m.features.edges, owner);
                               }));
    numbers(
        "edge_labels", [](const auto& m) -> auto& { return m.features.edge_labels; });
    numbers(
        "corners", [](const auto& m) -> auto& { return m.features.corners; });
    numbers(
        "ridges", [](const auto& m) -> auto& { return m.features.ridges; });
    numbers(
        "required_nodes", [](const auto& m) -> auto& { return m.features.required_nodes; });
    numbers(
        "required_edges", [](const auto& m) -> auto& { return m.features.required_edges; });
    numbers(
        "required_faces", [](const auto& m) -> auto& { return m.features.required_faces; });
    numbers(
        "required_elements", [](const auto& m) -> auto& { return m.features.required_elements; });
}

void bind_check(py::module_& module) {
    py::class_<Finding>(module, "Finding")
        .def_property_readonly("defect", [](const Finding& f) { return name(f.defect); })
        .def_readonly("count", &Finding::count)
        .def_readonly("example", &Finding::example)
        .def("__repr__", [](const Finding& f) {
            return "<" + std::string(name(f.defect)) + ": " + std::to_string(f.count) + ", " +
                   f.example + ">";
        });
    py::class_<CheckReport>(module, "CheckReport")
        .def_property_readonly("valid", &CheckReport::valid)
        .def_readonly("errors", &CheckReport::errors)
        .def_readonly("warnings", &CheckReport::warnings)
        .def_readonly("interior_faces", &CheckReport::interior_faces)
        .def_readonly("volume", &CheckReport::volume)
        .def_readonly("boundary_flux", &CheckReport::boundary_flux)
        .def("__repr__", [](const CheckReport& r) {
            return r.valid() ? std::string("<valid>") : "<not valid: " + r.summary() + ">";
        });
}

CheckReport check_mesh(AnyMesh& mesh) {
    PythonMonitor monitor{py::none(), py::none()};
    CheckReport report = monitor.call(
        [&] { return std::visit([](const auto& m) { return check(*m); }, mesh.mesh); });
    mesh.known_valid = report.valid();
    return report;
}

std::string description(const AnyMesh& mesh) {
    return std::visit(
        []<int D>(const std::shared_ptr<const Mesh<D>>& m) {
            return "<ameco.Mesh: " + std::to_string(m->points.size()) + " nodes, " +
                   std::to_string(m->elements.size()) + (D == 3 ? " tets, " : " triangles, ") +
                   std::to_string(m->faces.size()) + " boundary faces>";
        },
        mesh.mesh);
}

bool are_equal(const AnyMesh& a, const AnyMesh& b) {
    return std::visit(
        []<class A, class B>(const std::shared_ptr<A>& x, const std::shared_ptr<B>& y) {
            if constexpr (std::is_same_v<A, B>) {
                return *x == *y;
            } else {
                return false;
            }
        },
        a.mesh, b.mesh);
}

} // namespace

void require_valid(AnyMesh& mesh, PythonMonitor& monitor) {
    if (mesh.known_valid) {
        return;
    }
    const CheckReport report = monitor.call(
        [&] { return std::visit([](const auto& m) { return check(*m); }, mesh.mesh); });
    if (!report.valid()) {
        throw InputError("not a valid mesh: " + report.summary() +
                         " (mesh.check() lists everything)");
    }
    mesh.known_valid = true;
}

void bind_mesh(py::module_& module) {
    bind_check(module);
    py::class_<AnyMesh> type(module, "Mesh");
    bind_arrays(type);
    type.def_property_readonly("dimension", &AnyMesh::dimension);
    type.def_property_readonly("patch_names", [](const AnyMesh& mesh) {
        return std::visit([](const auto& m) { return m->patch_names; }, mesh.mesh);
    });
    type.def_readonly("repairs", &AnyMesh::repairs);
    type.def("check", &check_mesh);
    type.def("write", &write, py::arg("path"), py::arg("format") = "");
    type.def("__repr__", &description);
    type.def("__eq__", &are_equal);
    type.def("__eq__", [](const AnyMesh&, const py::object&) { return false; });
    type.attr("__hash__") = py::none();
    module.def("make_mesh", &make_mesh);
    module.def("read", &read);
    module.def("case", &make_case_mesh);
}

} // namespace ameco::python
