// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// A session: everything the window needs to come back to where it was left. A JSON file, schema
/// version 1, and beside it folders with the levels, one hierarchy for each end of the tree.
#pragma once

#include "gui/model/case_level.h"
#include "gui/scene/camera.h"
#include "gui/scene/scene_options.h"

#include <filesystem>
#include <string>
#include <vector>

namespace ameco::gui {

struct Session {
    std::string mesh;                ///< file of the finest level, absolute
    std::vector<StoredLevel> levels; ///< coarser ones, parents first; folders absolute
    int current = 0;                 ///< key of the level shown; the finest has the key 0
    std::vector<int> shown{0};       ///< key of each view's level; 1, 2 or 4 of them
    Camera camera;
    SceneOptions scene;
    HierarchyOptions options; ///< of the panel
    int threads = 0;
    bool percent = false, logarithmic = false; ///< of the histograms
};

/// Paths are written relative to the session's folder, so that a folder can be moved as a whole.
[[nodiscard]] std::string session_text(const Session& session, const std::filesystem::path& folder);

/// \param file  the session's, for messages and for relative paths
/// \throws InputError when the text is not JSON, of another version, or lacks something
[[nodiscard]] Session parse_session(const std::string& text, const std::filesystem::path& file);

/// \throws FileError, InputError
[[nodiscard]] Session read_session(const std::filesystem::path& file);
/// \throws FileError
void write_session(const std::filesystem::path& file, const Session& session);

/// Writes the levels, then the session that lists them.
/// \param levels  the whole tree, parents first; the first is the finest
/// \throws Error
void save_session(const std::filesystem::path& file, Session session, const CaseFile& mesh,
                  const std::vector<CaseLevel>& levels, Monitor& monitor);

} // namespace ameco::gui
