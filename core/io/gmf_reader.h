// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// What the binary and the text form of a GMF file have in common for a reader: sections of rows.
#pragma once

#include "core/base/id.h"
#include "core/io/file_bytes.h"
#include "core/io/gmf_keyword.h"
#include "core/io/io.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ameco::gmf {

/// One section of a file. Its count is known to fit into the file.
struct Section {
    int keyword = 0;
    std::int64_t count = 0;     ///< rows
    const char* rows = nullptr; ///< the first one; binary only
    std::int64_t place = 0;     ///< byte of the file where the section begins
};

/// A row that names a string: (keyword, number) -> text.
struct ReferenceString {
    std::int64_t keyword = 0;
    std::int64_t number = 0;
    std::string text;
};

/// Any number of nodes: the limit while Vertices have not been read yet.
inline constexpr std::int64_t unknown_count = std::numeric_limits<std::int32_t>::max();

/// Walks through the sections of a file. For each one, the caller allocates `count` rows and has
/// them filled by the `read_...` of its kind, or ignores it. All throw InputError.
class Reader {
public:
    virtual ~Reader() = default;
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    /// Where the content lies, if it is mapped from a file: parts that are read are given back.
    void set_file(const FileBytes* file) { file_ = file; }

    [[nodiscard]] int version() const { return version_; }
    [[nodiscard]] int dimension() const { return dimension_; }
    [[nodiscard]] const std::string& name() const { return name_; }
    /// e.g. "Medit binary, version 2"
    [[nodiscard]] virtual std::string format() const = 0;
    /// e.g. "byte 120" or "line 12"
    [[nodiscard]] virtual std::string place(const Section& section) const = 0;

    /// The next section that we know, Vertices first where the file allows it; nothing at the end.
    [[nodiscard]] virtual std::optional<Section> next() = 0;

    /// Leaves the rows of a section out.
    virtual void skip(const Section& section) = 0;

    /// \param coordinates  [count * dimension]
    /// \param labels       [count], or left empty if all are 0
    virtual void read_points(const Section& section, std::span<double> coordinates,
                             std::vector<int>& labels) = 0;

    /// Reads edges, triangles or tetrahedra; node numbers become 0-based.
    /// \param node_count  numbers above it are errors
    /// \param nodes       [count * nodes per cell]
    /// \param labels      [count]
    virtual void read_cells(const Section& section, std::int64_t node_count,
                            std::span<NodeId> nodes, std::span<int> labels) = 0;

    /// Reads a list of numbers, made 0-based; only those below 1 are errors.
    virtual void read_numbers(const Section& section, std::span<std::int32_t> numbers) = 0;

    virtual std::vector<ReferenceString> read_strings(const Section& section) = 0;

    /// Names of patches that stand in comments of a text file (keyword 0); complete after the last
    /// section.
    [[nodiscard]] virtual std::vector<ReferenceString> names_in_comments() const { return {}; }

    /// Type codes of a solution's fields; to be read before its rows.
    virtual std::vector<int> read_solution_types(Section& section) = 0;
    /// \param values  [count * values per row]
    virtual void read_reals(const Section& section, std::span<double> values) = 0;

    /// Records without meaning to us, of those that can be carried to another file.
    [[nodiscard]] virtual std::vector<OpaqueRecord> carried() const = 0;
    /// What was skipped and why; complete after the last section.
    [[nodiscard]] virtual std::vector<std::string> notes() const = 0;

protected:
    explicit Reader(std::string name) : name_(std::move(name)) {}

    [[noreturn]] void fail(const std::string& what) const;
    /// Row `row` (0-based) of `section` uses node `node` (1-based, as in the file).
    [[noreturn]] void fail_node(const Section& section, std::int64_t row, std::int64_t node,
                                std::int64_t node_count) const;
    [[noreturn]] void fail_label(const Section& section, std::int64_t row,
                                 std::int64_t label) const;
    [[noreturn]] void fail_number(const Section& section, std::int64_t row,
                                  std::int64_t number) const;

    /// Rows that are read.
    void forget(const char* begin, const char* end) const {
        if (file_ != nullptr) {
            file_->forget(begin, end);
        }
    }

    const FileBytes* file_ = nullptr;
    std::string name_;
    int version_ = 0;
    int dimension_ = 0;
};

/// A reader for the content of a file, or nothing if it is not GMF.
/// \param bytes  must outlive the reader
/// \param name   of the file, for messages
[[nodiscard]] std::unique_ptr<Reader> open_reader(std::string_view bytes, const std::string& name);

} // namespace ameco::gmf
