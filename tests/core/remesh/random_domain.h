// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Small random meshes of everything that a domain may have, for tests of the operators.
#pragma once

#include "core/remesh/geometry_classes.h"

#include <random>

namespace ameco::remesh_test {

enum class DomainKind {
    plain,            ///< a box
    regions,          ///< two regions, the faces between them listed
    unlisted_regions, ///< two regions, their border known from the elements only
    baffle,           ///< a wall without thickness, with the same nodes on both sides
    slit,             ///< a wall without thickness, with nodes of its own on either side
    hole,             ///< a box without some of its cells
    turned            ///< a box whose sides are along no axis
};

inline constexpr std::array all_domain_kinds{
    DomainKind::plain,  DomainKind::regions, DomainKind::unlisted_regions,
    DomainKind::baffle, DomainKind::slit,    DomainKind::hole,
    DomainKind::turned};

[[nodiscard]] const char* name(DomainKind kind);

/// A random mesh, and which of its patches are frozen.
template <int D>
struct RandomDomain {
    Mesh<D> mesh;
    FeatureOptions features;
    /// Relative rounding of volumes and areas: 0 where sides are along axes.
    double rounding = 0;
};

/// A box of a few cells, filled with random points on edges, sides and inside, flattened by up to
/// 2^20, with random required, listed and frozen entities; numbered at random. Sides are along the
/// axes but for `turned`, so that nodes lie on them to the bit. Valid; the same for the same seed.
///
/// Points are inserted by brute force, boundaries found likewise: none of what is tested is used.
template <int D>
[[nodiscard]] RandomDomain<D> random_domain(DomainKind kind, unsigned seed);

/// A random entry of a container that has one.
template <class Container>
[[nodiscard]] const auto& pick(const Container& from, std::mt19937& random) {
    return *(from.begin() +
             static_cast<std::ptrdiff_t>(random() % static_cast<std::size_t>(from.size())));
}

} // namespace ameco::remesh_test
