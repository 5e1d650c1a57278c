// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/multigrid/transfer_files.h"

#include "core/base/error.h"
#include "core/io/atomic_file.h"
#include "core/multigrid/matrix_file.h"

namespace ameco {
namespace {

/// One number per line below a line of explanation.
void write_numbers(const std::filesystem::path& path, const std::string& explanation,
                   const std::vector<int>& numbers) {
    std::string text = "# " + explanation + "\n";
    for (const int number : numbers) {
        text += std::to_string(number) + '\n';
    }
    write_whole_file(path, text);
}

std::vector<int> numbers_of(const IdVector<NodeId, NodeId>& nodes) {
    std::vector<int> numbers;
    numbers.reserve(nodes.size());
    for (const NodeId node : nodes) {
        numbers.push_back(node.valid() ? node.value() : -1);
    }
    return numbers;
}

std::vector<int> projected_nodes(const Transfer& transfer) {
    std::vector<int> numbers;
    for (const NodeId node : transfer.kind.ids()) {
        if (transfer.kind[node] == TransferKind::projected) {
            numbers.push_back(node.value());
        }
    }
    return numbers;
}

} // namespace

template <int D>
TransferFiles write_transfer_files(const std::filesystem::path& folder, int k, const Mesh<D>& fine,
                                   const Mesh<D>& coarse, const IdVector<NodeId, NodeId>& parent,
                                   Monitor& monitor) {
    const Transfer transfer = make_transfer(fine, coarse, parent, monitor);
    const TransferCheck checked = check(transfer, fine, coarse);
    const std::string number = std::to_string(k);
    if (!checked.passed()) {
        throw CheckFailed((folder / ("P_" + number + ".mtx")).string() +
                          ": not written: " + checked.failures());
    }
    const std::string coarse_name = "level " + std::to_string(k + 1);
    const std::string fine_name = "level " + number;
    const auto name = [&](const char* stem, const char* suffix) { return stem + number + suffix; };
    write_matrix_market(folder / name("P_", ".mtx"), transfer.P);
    write_petsc_matrix(folder / name("P_", ".petsc"), transfer.P);
    write_numbers(folder / name("parent_", ".txt"),
                  "per node of " + coarse_name + " the node of " + fine_name +
                      " at its place, from 0; -1: none",
                  numbers_of(transfer.parent));
    write_numbers(folder / name("projected_", ".txt"),
                  "nodes of " + fine_name + ", from 0, that are not in " + coarse_name +
                      " and were projected on its boundary",
                  projected_nodes(transfer));
    return {hashed(folder, name("P_", ".mtx")),
            hashed(folder, name("P_", ".petsc")),
            hashed(folder, name("parent_", ".txt")),
            hashed(folder, name("projected_", ".txt")),
            checked.nested,
            checked.interpolated,
            checked.projected,
            checked.largest_projection};
}

template TransferFiles write_transfer_files(const std::filesystem::path&, int, const Mesh<2>&,
                                            const Mesh<2>&, const IdVector<NodeId, NodeId>&,
                                            Monitor&);
template TransferFiles write_transfer_files(const std::filesystem::path&, int, const Mesh<3>&,
                                            const Mesh<3>&, const IdVector<NodeId, NodeId>&,
                                            Monitor&);

} // namespace ameco
