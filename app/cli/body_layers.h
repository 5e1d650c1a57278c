// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// `ameco case layer --surface S`: layers on a surface from a file.
#pragma once

#include "app/cli/command.h"

#include <string>

namespace CLI {
class App;
}

namespace ameco::cli {

/// What the case takes when it is given a surface; numbers are tested by the parser.
struct BodyLayers {
    std::string surface; ///< empty: the case is the plate
    double first_height = 0;
    int layers = 20;
    std::string farfield = "sphere";

    void add_options(CLI::App& app);
    /// Makes the mesh and writes it.
    void run(double growth, const std::string& output, Session& session) const;
};

} // namespace ameco::cli
