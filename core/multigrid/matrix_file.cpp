// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/multigrid/matrix_file.h"

#include "core/base/error.h"
#include "core/io/atomic_file.h"

#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace ameco {
namespace {

void write_text(AtomicFile& file, const std::string& text) {
    file.write(text.data(), text.size());
}

template <class Number>
void append(std::string& line, Number value) {
    std::array<char, 40> buffer;
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
    line.append(buffer.data(), end.ptr);
}

/// Big-endian bytes of a number.
template <class Bits, class Number>
void write_big_endian(AtomicFile& file, Number value) {
    static_assert(sizeof(Bits) == sizeof(Number));
    const Bits bits = std::bit_cast<Bits>(value);
    std::array<unsigned char, sizeof(Bits)> bytes;
    for (std::size_t i = 0; i < sizeof(Bits); ++i) {
        bytes[i] = static_cast<unsigned char>(bits >> (8 * (sizeof(Bits) - 1 - i)));
    }
    file.write(bytes.data(), bytes.size());
}

void write_int(AtomicFile& file, Eigen::Index value) {
    write_big_endian<std::uint32_t>(file, static_cast<std::int32_t>(value));
}

void write_double(AtomicFile& file, double value) {
    write_big_endian<std::uint64_t>(file, value);
}

/// PETSc's MAT_FILE_CLASSID and VEC_FILE_CLASSID.
constexpr int petsc_matrix = 1211216;
constexpr int petsc_vector = 1211214;

[[noreturn]] void refuse(const std::filesystem::path& path, std::int64_t line,
                         const std::string& what) {
    throw InputError(path.string() + ": line " + std::to_string(line) + ": " + what);
}

} // namespace

void write_matrix_market(const std::filesystem::path& path, const SparseMatrix& matrix) {
    AtomicFile file(path);
    write_text(file, "%%MatrixMarket matrix coordinate real general\n");
    write_text(file, std::to_string(matrix.rows()) + ' ' + std::to_string(matrix.cols()) + ' ' +
                         std::to_string(matrix.nonZeros()) + '\n');
    std::string line;
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        line.clear();
        for (SparseMatrix::InnerIterator it(matrix, i); it; ++it) {
            append(line, i + 1);
            line += ' ';
            append(line, it.col() + 1);
            line += ' ';
            append(line, it.value());
            line += '\n';
        }
        write_text(file, line);
    }
    file.commit();
}

SparseMatrix read_matrix_market(const std::filesystem::path& path) {
    std::ifstream in(path);
    if (!in) {
        throw FileError(path.string() + ": cannot be opened: check its name and permissions");
    }
    std::string line;
    std::int64_t number = 1;
    std::getline(in, line);
    if (line.rfind("%%MatrixMarket matrix coordinate real general", 0) != 0) {
        refuse(path, number, "not a real general MatrixMarket matrix in coordinate form");
    }
    do {
        ++number;
    } while (std::getline(in, line) && line.rfind('%', 0) == 0);
    long long rows = -1, columns = -1, entries = -1;
    std::istringstream(line) >> rows >> columns >> entries;
    if (rows < 0 || columns < 0 || entries < 0) {
        refuse(path, number, "expected the numbers of rows, columns and entries");
    }
    std::vector<Eigen::Triplet<double, int>> triplets;
    for (long long k = 0; k < entries; ++k) {
        ++number;
        std::getline(in, line);
        const char* at = line.data();
        const char* const end = at + line.size();
        long long i = 0, j = 0;
        double value = 0;
        const auto next = [&](auto& into) {
            while (at < end && *at == ' ') {
                ++at;
            }
            const auto result = std::from_chars(at, end, into);
            at = result.ptr;
            return result.ec == std::errc();
        };
        if (!in || !next(i) || !next(j) || !next(value) || i < 1 || i > rows || j < 1 ||
            j > columns) {
            refuse(path, number,
                   "expected a row, a column and a number of the " + std::to_string(entries) +
                       " entries announced");
        }
        triplets.emplace_back(static_cast<int>(i - 1), static_cast<int>(j - 1), value);
    }
    SparseMatrix matrix(rows, columns);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    return matrix;
}

void write_petsc_matrix(const std::filesystem::path& path, const SparseMatrix& matrix) {
    AtomicFile file(path);
    write_int(file, petsc_matrix);
    write_int(file, matrix.rows());
    write_int(file, matrix.cols());
    write_int(file, matrix.nonZeros());
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        write_int(file, matrix.outerIndexPtr()[i + 1] - matrix.outerIndexPtr()[i]);
    }
    for (Eigen::Index k = 0; k < matrix.nonZeros(); ++k) {
        write_int(file, matrix.innerIndexPtr()[k]);
    }
    for (Eigen::Index k = 0; k < matrix.nonZeros(); ++k) {
        write_double(file, matrix.valuePtr()[k]);
    }
    file.commit();
}

void write_petsc_vector(const std::filesystem::path& path, const Vector& vector) {
    AtomicFile file(path);
    write_int(file, petsc_vector);
    write_int(file, vector.size());
    for (const double value : vector) {
        write_double(file, value);
    }
    file.commit();
}

void write_matrix(const std::filesystem::path& path, const SparseMatrix& matrix) {
    if (path.extension() == ".mtx") {
        write_matrix_market(path, matrix);
    } else if (path.extension() == ".petsc") {
        write_petsc_matrix(path, matrix);
    } else {
        throw UsageError(path.string() +
                         ": its name must end in .mtx (MatrixMarket) or .petsc (PETSc binary)");
    }
}

} // namespace ameco
