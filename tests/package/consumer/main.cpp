// SPDX-License-Identifier: AGPL-3.0-or-later
#include <core/cases/cases.h>
#include <core/coarsen/coarsen.h>

#include <iostream>

int main() {
    const ameco::CoarsenOptions options;
    auto mesh = std::get<ameco::Mesh<3>>(
        ameco::make_case("layer", {{"nx", "6"}, {"ny", "6"}, {"nz", "16"}, {"growth", "1"}}));
    ameco::CoarsenReport report;
    const auto coarse =
        ameco::coarsen(ameco::finest_level(std::move(mesh), options), options, report);
    std::cout << report.nodes_before << " -> " << coarse.mesh.points.size() << '\n';
}
