// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Meshes made by formula, for demos, tests and the paper's figures: which there are, what their
/// parameters are, and one entry that makes any of them from names and values.
#pragma once

#include "core/mesh/mesh.h"

#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace ameco {

/// One parameter of a case, as the command line, the window and the manual print it.
struct CaseParameter {
    std::string name; ///< as given on the command line, without dashes: "first-height"
    std::string
        default_value; ///< what is used when it is not given; "" if that follows from others
    std::string unit;  ///< "m", "deg", "" for a pure number
    std::string range; ///< what is accepted: "> 0", "2 or 3", "uniform, alternating"
    std::string help;  ///< one line
};

/// A mesh that can be made by name.
struct CaseDescription {
    std::string name;    ///< "onera-m6"
    std::string summary; ///< one line
    std::vector<CaseParameter> parameters;
};

/// All cases, in the order of the manual.
[[nodiscard]] const std::vector<CaseDescription>& cases();

/// Makes the case `name`. Presets ("m6-67k") are values of the case's parameter `preset`; the other
/// parameters then change the preset. Same arguments, same bytes.
///
/// \param parameters  values by parameter name; what is absent keeps its default
/// \throws UsageError for an unknown case or parameter (with the nearest known name) and for a
///         value out of its range
[[nodiscard]] std::variant<Mesh<3>, Mesh<2>>
make_case(std::string_view name, const std::map<std::string, std::string>& parameters = {});

} // namespace ameco
