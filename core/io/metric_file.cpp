// SPDX-License-Identifier: AGPL-3.0-or-later
// The part of io.h that needs metrics taken apart and put together: read_metric, write_metric.
#include "core/io/gmf.h"
#include "core/io/io.h"

#include "core/base/parallel.h"

namespace ameco {
namespace {

constexpr std::size_t grain = 4096;

template <int D>
MetricField<D> to_metrics(const IdVector<NodeId, Tensor<D>>& tensors) {
    MetricField<D> field(tensors.size());
    parallel_for(tensors.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (NodeId node(begin); node.index() < end; node = NodeId(node.index() + 1)) {
            field[node] = from_tensor<D>(tensors[node]);
        }
    });
    return field;
}

/// The tensor if the file's numbers are taken in VTK's order, xx yy zz xy yz xz.
Tensor<3> in_vtk_order(const Tensor<3>& tensor) {
    Tensor<3> file{};
    for (std::size_t k = 0; k < file.size(); ++k) {
        file[static_cast<std::size_t>(gmf::tensor_place<3>[k])] = tensor[k];
    }
    const auto [xx, yy, zz, xy, yz, xz] = file;
    return {xx, xy, xz, yy, yz, zz};
}

Tensor<2> in_vtk_order(const Tensor<2>& tensor) {
    return {tensor[0], tensor[2], tensor[1]}; // the file's numbers taken as xx yy xy
}

/// Names the first tensor that is not positive definite, and the usual reason: an exporter that
/// wrote the components in another program's order.
template <int D>
void check_positive(const IdVector<NodeId, Tensor<D>>& tensors, const MetricField<D>& field,
                    const std::string& name) {
    std::size_t bad = 0;
    NodeId first;
    for (const NodeId node : field.ids()) {
        if (!is_valid(field[node])) {
            first = bad == 0 ? node : first;
            ++bad;
        }
    }
    if (bad == 0) {
        return;
    }
    const std::size_t n = field.size();
    std::string text = name + ": the tensor of vertex " + std::to_string(first.value() + 1) +
                       " is not positive definite (" + std::to_string(bad) + " of " +
                       std::to_string(n) + " are not)";
    std::size_t good_in_vtk_order = 0;
    for (const NodeId node : tensors.ids()) {
        good_in_vtk_order += is_valid(from_tensor<D>(in_vtk_order(tensors[node]))) ? 1 : 0;
    }
    constexpr double nearly_all = 0.99;
    if (good_in_vtk_order > n - bad &&
        static_cast<double>(good_in_vtk_order) >= nearly_all * static_cast<double>(n)) {
        text += "; taken in VTK's order (" +
                std::string(D == 3 ? "xx yy zz xy yz xz" : "xx yy xy") + ") " +
                std::to_string(good_in_vtk_order) +
                " would be: export it again in Medit's order (" +
                (D == 3 ? "xx xy yy xz yz zz" : "xx xy yy") + ")";
    } else {
        text += "; a metric must be: export it again";
    }
    throw InputError(text);
}

template <int D>
MetricField<D> checked_metrics(const IdVector<NodeId, Tensor<D>>& tensors,
                               const std::string& name) {
    MetricField<D> field = to_metrics<D>(tensors);
    check_positive<D>(tensors, field, name);
    return field;
}

} // namespace

MetricFile read_metric(const std::filesystem::path& path) {
    TensorFile source = read_tensors(path);
    MetricFile file;
    if (const auto* solid = std::get_if<IdVector<NodeId, Tensor<3>>>(&source.tensors)) {
        file.field = checked_metrics<3>(*solid, path.string());
    } else {
        const auto& flat = std::get<IdVector<NodeId, Tensor<2>>>(source.tensors);
        file.field = checked_metrics<2>(flat, path.string());
    }
    file.format = std::move(source.format);
    file.format_version = source.format_version;
    file.notes = std::move(source.notes);
    return file;
}

template <int D>
void write_metric(const std::filesystem::path& path, const MetricField<D>& field,
                  const WriteOptions& options) {
    IdVector<NodeId, Tensor<D>> tensors(field.size());
    parallel_for(field.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (NodeId node(begin); node.index() < end; node = NodeId(node.index() + 1)) {
            tensors[node] = to_tensor<D>(field[node]);
        }
    });
    write_tensors<D>(path, tensors, options);
}

template void write_metric<2>(const std::filesystem::path&, const MetricField<2>&,
                              const WriteOptions&);
template void write_metric<3>(const std::filesystem::path&, const MetricField<3>&,
                              const WriteOptions&);

} // namespace ameco
