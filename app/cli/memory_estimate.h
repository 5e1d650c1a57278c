// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// How much memory coarsening a mesh will take.
#pragma once

#include <cstdint>

namespace ameco::cli {

/// Peak memory of `ameco coarsen` [bytes], from the counts of the finest mesh; within about a
/// quarter. Fitted to measured runs: see memory_estimate.cpp.
[[nodiscard]] double coarsening_memory(int dimension, std::int64_t nodes, std::int64_t elements);

} // namespace ameco::cli
