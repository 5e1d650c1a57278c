// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/python/transfer_binding.h"

#include "app/python/arrays.h"
#include "app/python/mesh_binding.h"
#include "core/multigrid/transfer.h"

#include <utility>

namespace ameco::python {
namespace {

/// Node numbers from Python, if they are parents: each coarse node is where its fine node is.
template <int D>
IdVector<NodeId, NodeId> parents(const py::array_t<int, py::array::c_style>& given,
                                 const Mesh<D>& fine, const Mesh<D>& coarse) {
    if (static_cast<std::size_t>(given.size()) != coarse.points.size()) {
        return {};
    }
    IdVector<NodeId, NodeId> parent(coarse.points.size());
    for (const NodeId v : coarse.points.ids()) {
        const NodeId p(given.data()[v.index()]);
        if (p.valid() && (!fine.points.contains(p) || fine.points[p] != coarse.points[v])) {
            return {};
        }
        parent[v] = p;
    }
    return parent;
}

/// The matrix as compressed rows: shape, data, indices, indptr. The arrays look into `transfer`.
py::tuple arrays_of(const std::shared_ptr<const Transfer>& transfer) {
    const SparseMatrix& P = transfer->P;
    const auto entries = static_cast<py::ssize_t>(P.nonZeros());
    return py::make_tuple(py::make_tuple(P.rows(), P.cols()),
                          view(P.valuePtr(), {entries}, {}, transfer),
                          view(P.innerIndexPtr(), {entries}, {}, transfer),
                          view(P.outerIndexPtr(), {P.outerSize() + 1}, {}, transfer));
}

py::tuple transfer(AnyMesh& fine, AnyMesh& coarse,
                   const py::array_t<int, py::array::c_style>& given, bool checked,
                   const py::object& progress, const py::object& cancel) {
    if (fine.mesh.index() != coarse.mesh.index()) {
        throw UsageError("coarse: has another dimension than the fine mesh");
    }
    PythonMonitor monitor(progress, cancel);
    require_valid(fine, monitor);
    require_valid(coarse, monitor);
    return arrays_of(monitor.call([&] {
        return std::visit(
            [&]<int D>(const std::shared_ptr<const Mesh<D>>& f) {
                const Mesh<D>& c = *std::get<std::shared_ptr<const Mesh<D>>>(coarse.mesh);
                auto made = std::make_shared<const Transfer>(
                    make_transfer(*f, c, parents(given, *f, c), monitor));
                if (checked) {
                    if (const TransferCheck result = check(*made, *f, c); !result.passed()) {
                        throw CheckFailed("transfer: " + result.failures());
                    }
                }
                return made;
            },
            fine.mesh);
    }));
}

} // namespace

void bind_transfer(py::module_& module) {
    module.def("transfer", &transfer);
}

} // namespace ameco::python
