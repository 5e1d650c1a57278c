// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Sparse matrices as files, for other people's solvers.
#pragma once

#include "core/multigrid/sparse.h"

#include <filesystem>

namespace ameco {

/// Writes MatrixMarket text ("matrix coordinate real general", 1-based), the shortest decimals that
/// give the same numbers back. The file appears whole or not at all.
/// \throws FileError
void write_matrix_market(const std::filesystem::path& path, const SparseMatrix& matrix);

/// Reads what `write_matrix_market` writes, and any other general real coordinate file; entries
/// that are there twice are added. \throws FileError; InputError with the line, also where entries
/// are missing or too many
[[nodiscard]] SparseMatrix read_matrix_market(const std::filesystem::path& path);

/// Writes PETSc's binary format for MatLoad: big-endian, 32-bit indices.
/// \throws FileError
void write_petsc_matrix(const std::filesystem::path& path, const SparseMatrix& matrix);

/// The same for a vector (VecLoad).
/// \throws FileError
void write_petsc_vector(const std::filesystem::path& path, const Vector& vector);

/// Writes in the format of the suffix: .mtx (MatrixMarket) or .petsc.
/// \throws FileError; UsageError for another suffix
void write_matrix(const std::filesystem::path& path, const SparseMatrix& matrix);

} // namespace ameco
