// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What must hold of a mesh under edit after every single operation, in exact arithmetic.
#pragma once

#include "core/remesh/cavity.h"

#include <map>
#include <memory>
#include <string>

namespace ameco::remesh_test {

/// Remembers a mesh, and finds what an operation has broken. All of it is brute force.
///
/// Valid: \see core/mesh/check.h. Consistent: balls hold the elements at their nodes, real and
/// ghost elements meet in pairs that face each other, marks agree with elements. Kept: volume of
/// each region, area of each side of each patch, length of each ridge, faces inside the domain,
/// frozen nodes, frozen faces, required and listed entities.
template <int D>
class Audit {
public:
    /// \param rounding  how far volumes and areas may change [-]; 0: not at all, which asks for
    /// sides
    ///                  along the axes, whose nodes are on them to the bit
    Audit(const EditMesh<D>& mesh, double rounding);
    ~Audit();

    /// What is wrong with the mesh now; empty if nothing.
    [[nodiscard]] std::string complaint(const EditMesh<D>& mesh) const;

private:
    struct Kept;
    [[nodiscard]] Kept measure(const EditMesh<D>& mesh) const;

    double rounding_;
    std::unique_ptr<Kept> kept_;
};

/// Volume of a cavity, of a star, and of the star with all elements counted positive; in units that
/// are the same for all three.
struct StarVolumes {
    bool equal;         ///< star and cavity have the same signed volume, exactly
    bool minimal;       ///< ... and so they have with all elements of the star counted positive
    bool all_positive;  ///< the star has real elements, all of positive volume
    bool never_smaller; ///< the volume with all elements positive is not below the cavity's
};

template <int D>
[[nodiscard]] StarVolumes compare_volumes(const EditMesh<D>& mesh, const Cavity<D>& cavity,
                                          const Star<D>& star);

} // namespace ameco::remesh_test
