// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Pictures of a hierarchy as SVG: its aspect-ratio histogram, and its layers level by level.
#pragma once

#include "core/hierarchy/hierarchy.h"
#include "core/mesh/mesh.h"
#include "core/metric/aspect_ratio.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ameco {

/// Share of the nodes in each aspect-ratio class, one colour per level (figures 11, 13, 18).
/// \param levels  classes of all levels on the edges of the finest one's
[[nodiscard]] std::string histogram_svg(const std::vector<AspectRatioClasses>& levels);

/// A plane part of a mesh that shows layers, and the window to look through.
///
/// At an aspect ratio of 1e5 a picture in true scale shows lines: the view is scaled across the
/// layers, and says so.
template <int D>
struct SectionView {
    int patch = 0; ///< D = 3: the planar patch that is drawn; D = 2: unused, the whole mesh is
    Vec<D> origin = Vec<D>::Zero(); ///< a node at the foot of the layers [L]
    Vec<D> along = Vec<D>::Zero();  ///< unit vector with the layers
    Vec<D> across = Vec<D>::Zero(); ///< unit vector away from the wall
    double width = 1;               ///< of the window along the layers [L]
    double height = 1;              ///< of the window across the layers [L]
};

/// The most stretched triangle of the planar patches (D = 3) or of the mesh (D = 2) decides where
/// to look; nothing if a mesh in 3-D has no planar patch.
template <int D>
[[nodiscard]] std::optional<SectionView<D>> find_section(const Mesh<D>& mesh);

/// The triangles of one level seen through the window.
struct SectionPanel {
    std::string title;
    std::vector<std::array<double, 6>> triangles; ///< x, y of the corners in [0, 1], y upwards
};

template <int D>
[[nodiscard]] SectionPanel draw_section(const Mesh<D>& mesh, const SectionView<D>& view,
                                        const std::string& title);

/// The panels of all levels beside each other.
/// \param scale  how many times the view is stretched across the layers [-]
[[nodiscard]] std::string sections_svg(const std::vector<SectionPanel>& panels, double scale);

/// The layers of a hierarchy, level by level: takes the levels' meshes, finest first, one at a
/// time.
template <int D>
class LayerPictures {
public:
    void add(const Mesh<D>& mesh, const LevelStatistics& level);
    /// Empty where there is no section to show.
    [[nodiscard]] std::string svg() const;

private:
    std::optional<SectionView<D>> view_; ///< that of the finest level, for all
    std::vector<SectionPanel> panels_;
};

/// Writes histogram.svg and, where there is a section to show, layers.svg into the folder of a
/// finished hierarchy; reads one level at a time. Returns the names of the files.
/// \throws FileError
template <int D>
std::vector<std::string> write_pictures(const std::filesystem::path& folder,
                                        const Hierarchy& hierarchy);

} // namespace ameco
