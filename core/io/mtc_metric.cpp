// SPDX-License-Identifier: AGPL-3.0-or-later
// The metric of MTC.
#include "core/io/mtc.h"

#include "core/io/text_file.h"
#include "core/io/text_scanner.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace ameco::mtc {
namespace {

/// Off-diagonal components that differ by more, relative to the largest component, are an error and
/// not rounding.
constexpr double asymmetry = 1e-6;

struct Form {
    int dimension;
    bool has_dimension; ///< a second number in the header
    bool full;          ///< d * d numbers per node, else the upper triangle by rows
};

/// The header may lie about nothing: the amount of numbers decides what it means.
std::optional<Form> find_form(std::int64_t nodes, std::int64_t second, std::int64_t numbers) {
    for (const bool has_dimension : {true, false}) {
        for (const int d : {3, 2}) {
            for (const bool full : {true, false}) {
                const std::int64_t per_node = full ? d * d : d * (d + 1) / 2;
                if ((!has_dimension || second == d) &&
                    nodes * per_node + (has_dimension ? 2 : 1) == numbers) {
                    return Form{d, has_dimension, full};
                }
            }
        }
    }
    return std::nullopt;
}

template <int D>
IdVector<NodeId, Tensor<D>> read_rows(TextScanner& text, std::int64_t nodes, bool full) {
    IdVector<NodeId, Tensor<D>> tensors(static_cast<std::size_t>(nodes));
    for (const NodeId node : tensors.ids()) {
        const auto where = [&] { return "node " + std::to_string(node.value() + 1) + ": "; };
        Mat<D> m = Mat<D>::Zero();
        for (int i = 0; i < D; ++i) {
            for (int k = full ? 0 : i; k < D; ++k) {
                m(i, k) = text.real(where);
            }
        }
        if (!m.allFinite()) {
            text.fail_here(where() + "a component of the metric is not finite");
        }
        std::size_t place = 0;
        for (int i = 0; i < D; ++i) {
            for (int k = i; k < D; ++k) {
                if (full && std::abs(m(i, k) - m(k, i)) > asymmetry * m.cwiseAbs().maxCoeff()) {
                    text.fail_here(where() + "the matrix is not symmetric; a metric must be");
                }
                tensors[node][place++] = m(i, k);
            }
        }
    }
    return tensors;
}

} // namespace

TensorFile read_tensors(const Source& source) {
    TextScanner text(source.bytes, source.name, '\0');
    const auto where = [] { return std::string("number of nodes: "); };
    const std::int64_t nodes = text.integer(where);
    const std::int64_t numbers = count_tokens(source.bytes);
    text.skip_blank();
    const std::string_view next = text.token();
    const std::int64_t second = next == "3" ? 3 : next == "2" ? 2 : 0;
    const bool possible = nodes > 0 && text.has_room(nodes, 3);
    const std::optional<Form> form = possible ? find_form(nodes, second, numbers) : std::nullopt;
    if (!form) {
        text.fail_here("announces " + std::to_string(nodes) + " nodes, but " +
                       std::to_string(numbers - 1) +
                       " numbers follow, which are no matrices of so many nodes; it is truncated, "
                       "damaged, or no metric of MTC");
    }
    if (form->has_dimension) {
        text.take(next.size());
    }
    TensorFile file;
    file.format = "MTC metric";
    if (form->dimension == 3) {
        file.tensors = read_rows<3>(text, nodes, form->full);
    } else {
        file.tensors = read_rows<2>(text, nodes, form->full);
    }
    return file;
}

template <int D>
void write_tensors(const std::filesystem::path& path, const IdVector<NodeId, Tensor<D>>& tensors,
                   const WriteOptions&) {
    TextFile file(path);
    file.number(tensors.size(), '\n');
    for (const Tensor<D>& tensor : tensors) {
        Mat<D> m;
        std::size_t place = 0;
        for (int i = 0; i < D; ++i) {
            for (int k = i; k < D; ++k) {
                m(i, k) = m(k, i) = tensor[place++];
            }
        }
        for (int i = 0; i < D * D; ++i) {
            file.number(m(i / D, i % D), i + 1 < D * D ? ' ' : '\n');
        }
    }
    file.commit();
}

template void write_tensors<2>(const std::filesystem::path&, const IdVector<NodeId, Tensor<2>>&,
                               const WriteOptions&);
template void write_tensors<3>(const std::filesystem::path&, const IdVector<NodeId, Tensor<3>>&,
                               const WriteOptions&);

} // namespace ameco::mtc
