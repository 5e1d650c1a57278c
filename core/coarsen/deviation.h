// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// How far the boundary of a level is from the finest one, for its report.
#pragma once

#include "core/coarsen/coarsen.h"

#include <algorithm>

namespace ameco {

/// Largest bound of a face, and largest bound over the mean edge of its face.
template <int D>
void measure_deviation(const Mesh<D>& mesh, const GeometryClasses<D>& geometry,
                       CoarsenReport& report) {
    for (const FaceId f : mesh.faces.ids()) {
        double edges = 0;
        int count = 0;
        for (std::size_t i = 0; i + 1 < D; ++i) {
            for (std::size_t j = i + 1; j < D; ++j) {
                edges += (mesh.points[mesh.faces[f][i]] - mesh.points[mesh.faces[f][j]]).norm();
                ++count;
            }
        }
        report.deviation = std::max(report.deviation, geometry.deviation[f]);
        report.deviation_relative =
            std::max(report.deviation_relative, geometry.deviation[f] * count / edges);
    }
}

} // namespace ameco
