// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/metric/element_measures.h"

#include "core/base/parallel.h"

namespace ameco {

template <int D>
Tensor<D> root_of(const Metric<D>& m) {
    const Mat<D> s = m.directions * m.sizes.asDiagonal() * m.directions.transpose();
    Tensor<D> tensor;
    int k = 0;
    for (int r = 0; r < D; ++r) {
        for (int c = r; c < D; ++c) {
            tensor[k++] = s(r, c);
        }
    }
    return tensor;
}

template <int D>
RootField<D> make_root_field(const MetricField<D>& field) {
    RootField<D> root(field.size());
    parallel_for(field.size(), 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            root[NodeId(i)] = root_of<D>(field[NodeId(i)]);
        }
    });
    return root;
}

#define AMECO_INSTANTIATE(D)                                                                       \
    template Tensor<D> root_of(const Metric<D>&);                                                  \
    template RootField<D> make_root_field(const MetricField<D>&);

AMECO_INSTANTIATE(2)
AMECO_INSTANTIATE(3)
#undef AMECO_INSTANTIATE

} // namespace ameco
