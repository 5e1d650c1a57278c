// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/multigrid/matrix_file.h"

#include "core/base/error.h"
#include "core/io/atomic_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <limits>
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

const std::string market_banner = "%%MatrixMarket matrix coordinate real general";

[[noreturn]] void refuse(const std::filesystem::path& path, std::int64_t line,
                         const std::string& what) {
    throw InputError(path.string() + ": line " + std::to_string(line) + ": " + what);
}

/// The next line that is not blank; false at the end of the file.
bool next_line(std::istream& in, std::string& line, std::int64_t& number) {
    do {
        ++number;
        if (!std::getline(in, line)) {
            return false;
        }
    } while (line.find_first_not_of(" \t\r") == std::string::npos);
    return true;
}

/// Numbers separated by blanks, and nothing else on the line.
template <class... Numbers>
bool parse(const std::string& line, Numbers&... numbers) {
    const char* at = line.data();
    const char* const end = at + line.size();
    const auto skip_blanks = [&] {
        while (at < end && (*at == ' ' || *at == '\t' || *at == '\r')) {
            ++at;
        }
    };
    const auto next = [&](auto& into) {
        skip_blanks();
        if (end - at > 1 && at[0] == '+' && at[1] != '-') {
            ++at; // C++ reads no plus sign, Fortran writes them
        }
        const auto result = std::from_chars(at, end, into);
        at = result.ptr;
        return result.ec == std::errc();
    };
    const bool all = (next(numbers) && ...);
    skip_blanks();
    return all && at == end;
}

/// The format's indices are unbounded, ours are `int`.
constexpr std::int64_t most_rows = std::numeric_limits<int>::max();

struct MatrixSize {
    std::int64_t rows = 0, columns = 0, entries = 0;
};

MatrixSize read_size(std::istream& in, const std::filesystem::path& path, std::int64_t& number) {
    std::string line;
    MatrixSize size;
    do {
        if (!next_line(in, line, number)) {
            refuse(path, number, "ends before the numbers of rows, columns and entries");
        }
    } while (line.front() == '%');
    if (!parse(line, size.rows, size.columns, size.entries) || size.rows < 0 || size.columns < 0 ||
        size.entries < 0) {
        refuse(path, number, "expected the numbers of rows, columns and entries");
    }
    if (std::max({size.rows, size.columns, size.entries}) > most_rows) {
        refuse(path, number, "larger than " + std::to_string(most_rows) + " cannot be read");
    }
    return size;
}

} // namespace

void write_matrix_market(const std::filesystem::path& path, const SparseMatrix& matrix) {
    AtomicFile file(path);
    write_text(file, market_banner + "\n");
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
    if (line.rfind(market_banner, 0) != 0) {
        refuse(path, number, "not a real general MatrixMarket matrix in coordinate form");
    }
    const MatrixSize size = read_size(in, path, number);
    std::vector<Eigen::Triplet<double, int>> triplets;
    for (std::int64_t k = 0; k < size.entries; ++k) {
        std::int64_t i = 0, j = 0;
        double value = 0;
        if (!next_line(in, line, number) || !parse(line, i, j, value) || i < 1 || i > size.rows ||
            j < 1 || j > size.columns) {
            refuse(path, number,
                   "expected a row, a column and a number: entry " + std::to_string(k + 1) +
                       " of the " + std::to_string(size.entries) + " announced");
        }
        triplets.emplace_back(static_cast<int>(i - 1), static_cast<int>(j - 1), value);
    }
    if (next_line(in, line, number)) {
        refuse(path, number,
               "more than the " + std::to_string(size.entries) + " entries announced");
    }
    SparseMatrix matrix(size.rows, size.columns);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    return matrix;
}

void write_petsc_matrix(const std::filesystem::path& path, const SparseMatrix& matrix) {
    if (!matrix.isCompressed()) {
        SparseMatrix compressed = matrix;
        compressed.makeCompressed();
        return write_petsc_matrix(path, compressed);
    }
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
