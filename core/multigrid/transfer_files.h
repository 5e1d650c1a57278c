// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The transfer between two levels of a hierarchy as files in its folder.
///
///     P_k.mtx          prolongation from level k + 1 to level k, all nodes (matrix_file.h)
///     P_k.petsc        the same for PETSc's MatLoad
///     parent_k.txt     injection: per node of level k + 1 the number, from 0, of the node of
///                      level k at the same place; -1 if there is none
///     projected_k.txt  numbers, from 0, of the nodes of level k that were projected
///
/// Lines that begin with # say what the text files hold; NumPy's loadtxt skips them.
#pragma once

#include "core/hierarchy/hierarchy_folder.h"
#include "core/multigrid/transfer.h"

namespace ameco {

/// Makes the transfer from level k + 1 to level k, checks it, and writes its files.
///
/// \param k       number of the fine level
/// \param parent  as `coarsen` returns it; empty: nodes with equal coordinates are matched
/// \throws CheckFailed  the transfer is not what it must be (transfer.h): nothing is written
/// \throws FileError, Cancelled
template <int D>
[[nodiscard]] TransferFiles write_transfer_files(const std::filesystem::path& folder, int k,
                                                 const Mesh<D>& fine, const Mesh<D>& coarse,
                                                 const IdVector<NodeId, NodeId>& parent = {},
                                                 Monitor& monitor = Monitor::silent());

} // namespace ameco
