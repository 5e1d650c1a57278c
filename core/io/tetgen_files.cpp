// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/tetgen_files.h"

#include "core/io/file_bytes.h"
#include "core/io/mixed_mesh.h"
#include "core/io/patch_names.h"
#include "core/io/text_file.h"
#include "core/io/text_scanner.h"

#include <cmath>
#include <limits>

namespace ameco::tetgen_files {
namespace {

constexpr char comment = '#';

std::filesystem::path with_suffix(std::filesystem::path path, const char* suffix) {
    return path.replace_extension(suffix);
}

/// One of the files, open for reading rows.
class File {
public:
    File(std::string_view bytes, const std::string& name)
        : text_(bytes, name, comment, TextScanner::Rows::lines) {}

    /// The first line.
    std::vector<std::int64_t> header(std::size_t least) {
        std::vector<std::int64_t> numbers;
        if (!text_.next_row()) {
            text_.fail_expected("first line: ", "counts");
        }
        while (text_.skip_blank() && numbers.size() < 8) {
            numbers.push_back(integer());
        }
        if (numbers.size() < least) {
            text_.fail_here("the first line needs at least " + std::to_string(least) + " counts");
        }
        return numbers;
    }
    /// Goes to the next row, takes its number.
    std::int64_t begin_row(std::int64_t row) {
        row_ = row;
        if (!text_.next_row()) {
            text_.fail_expected(where(), "a row");
        }
        return integer();
    }
    std::int64_t integer() {
        return text_.integer([&] { return where(); });
    }
    double real() {
        return text_.real([&] { return where(); });
    }
    /// A node of a row, 0-based.
    NodeId node(std::int64_t first_number) {
        const std::int64_t number = integer() - first_number;
        if (number < 0 || number > std::numeric_limits<std::int32_t>::max()) {
            text_.fail_here(where() + "there is no node " + std::to_string(number + first_number));
        }
        return NodeId(static_cast<std::int32_t>(number));
    }
    int label() {
        const double value = real();
        if (!(std::abs(value) <= std::numeric_limits<std::int32_t>::max())) {
            text_.fail_here(where() + "a marker does not fit into 32 bits");
        }
        rounded_ = rounded_ || value != std::floor(value);
        return static_cast<int>(value);
    }
    [[nodiscard]] bool has_rest() { return text_.skip_blank(); }
    [[nodiscard]] bool rounded() const { return rounded_; }
    void check_room(std::int64_t rows, std::int64_t numbers) const {
        if (!text_.has_room(rows, numbers)) {
            text_.fail_room("the first line", rows);
        }
    }
    TextScanner& text() { return text_; }

private:
    [[nodiscard]] std::string where() const {
        return row_ < 0 ? "first line: " : "row " + std::to_string(row_ + 1) + ": ";
    }
    TextScanner text_;
    std::int64_t row_ = -1;
    bool rounded_ = false; ///< whether a label was no whole number
};

template <int D>
class Reader {
public:
    explicit Reader(const Source& source) : source_(source) {}

    /// \return  false if its nodes are of another dimension
    bool read_nodes() {
        const std::filesystem::path path = with_suffix(source_.path, ".node");
        const FileBytes bytes(path);
        File file(bytes.view(), path.string());
        const std::vector<std::int64_t> header = file.header(2);
        if (header[1] != 2 && header[1] != 3) {
            file.text().fail_here("the dimension is " + std::to_string(header[1]) +
                                  ", but must be 2 or 3");
        }
        if (header[1] != D) {
            return false;
        }
        const std::int64_t attributes = header.size() > 2 ? header[2] : 0;
        const bool marked = header.size() > 3 && header[3] > 0;
        file.check_room(header[0], D + 1);
        mixed_.points.reserve(static_cast<std::size_t>(header[0]));
        bool any_label = false;
        for (std::int64_t i = 0; i < header[0]; ++i) {
            const std::int64_t number = file.begin_row(i);
            first_number_ = i == 0 ? number : first_number_;
            if (number != first_number_ + i || (first_number_ != 0 && first_number_ != 1)) {
                file.text().fail_here("node " + std::to_string(number) +
                                      " is out of order: nodes are numbered one by one, from 0 "
                                      "or 1");
            }
            Vec<D> x;
            for (int k = 0; k < D; ++k) {
                x[k] = file.real();
            }
            mixed_.points.push_back(x);
            for (std::int64_t k = 0; k < attributes; ++k) {
                static_cast<void>(file.real());
            }
            if (marked) {
                mixed_.labels.push_back(file.label());
                any_label = any_label || mixed_.labels.raw().back() != 0;
            }
        }
        if (!any_label) {
            mixed_.labels.clear();
        }
        return true;
    }

    MeshFile read_rest() {
        MeshFile result;
        result.format = D == 3 ? "TetGen" : "Triangle";
        read_elements(result.changes);
        read_faces(result.notes);
        finish_mesh(std::move(mixed_), {source_.name, static_cast<int>(first_number_), false},
                    result);
        return result;
    }

private:
    void read_elements(std::vector<std::string>& changes) {
        const std::filesystem::path path = with_suffix(source_.path, ".ele");
        const FileBytes bytes(path);
        File file(bytes.view(), path.string());
        const std::vector<std::int64_t> header = file.header(2);
        if (header[1] < D + 1 || header[1] > 10) {
            file.text().fail_here("elements of " + std::to_string(header[1]) +
                                  " nodes cannot be read");
        }
        file.check_room(header[0], header[1] + 1);
        for (std::int64_t i = 0; i < header[0]; ++i) {
            static_cast<void>(file.begin_row(i));
            Simplex<D> s;
            for (NodeId& node : s) {
                node = file.node(first_number_);
            }
            for (std::int64_t k = D + 1; k < header[1]; ++k) {
                static_cast<void>(file.integer()); // nodes amid the edges
            }
            const int region = file.has_rest() ? file.label() : 0;
            if constexpr (D == 3) {
                mixed_.tetrahedra.add(s, region);
            } else {
                mixed_.triangles.add(s, region);
            }
        }
        if (header[1] > D + 1) {
            changes.emplace_back("elements of second order were taken as straight ones");
        }
        if (file.rounded()) {
            changes.emplace_back("attributes of elements were rounded to whole numbers of regions");
        }
    }

    void read_faces(std::vector<std::string>& notes) {
        const std::filesystem::path path = with_suffix(source_.path, D == 3 ? ".face" : ".edge");
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(path, ignored)) {
            notes.push_back("there is no " + path.filename().string() +
                            ": the boundary has no faces yet");
            return;
        }
        const FileBytes bytes(path);
        File file(bytes.view(), path.string());
        const std::vector<std::int64_t> header = file.header(1);
        const bool marked = header.size() > 1 && header[1] > 0;
        file.check_room(header[0], D + 1);
        for (std::int64_t i = 0; i < header[0]; ++i) {
            static_cast<void>(file.begin_row(i));
            Facet<D> f;
            for (NodeId& node : f) {
                node = file.node(first_number_);
            }
            const int patch = marked ? file.label() : 0;
            if constexpr (D == 3) {
                mixed_.triangles.add(f, patch);
            } else {
                mixed_.lines.add(f, patch);
            }
        }
        while (file.text().next_row()) { // to the comments behind the rows
        }
        (D == 3 ? mixed_.face_names : mixed_.line_names) =
            names_in_comments(file.text().patch_comments());
    }

    const Source& source_;
    MixedMesh<D> mixed_;
    std::int64_t first_number_ = 1;
};

} // namespace

MeshFile read(const Source& source) {
    Reader<3> solid(source);
    if (solid.read_nodes()) {
        return solid.read_rest();
    }
    Reader<2> plane(source);
    static_cast<void>(plane.read_nodes());
    return plane.read_rest();
}

namespace {

template <class Cells, class Labels>
void write_rows(TextFile& file, const Cells& cells, const Labels& labels) {
    std::int64_t row = 1;
    for (const auto id : cells.ids()) {
        file.number(row++, ' ');
        for (const NodeId node : cells[id]) {
            file.number(std::int64_t{node.value()} + 1, ' ');
        }
        file.number(labels[id], '\n');
    }
}

} // namespace

template <int D>
std::vector<std::string> write(const std::filesystem::path& path, const Mesh<D>& mesh,
                               const WriteOptions&) {
    std::vector<std::string> notes;
    TextFile nodes(with_suffix(path, ".node"));
    nodes.number(mesh.points.size(), ' ');
    nodes.number(D, ' ');
    nodes.text(mesh.labels.empty() ? "0 0\n" : "0 1\n");
    for (const NodeId node : mesh.points.ids()) {
        nodes.number(std::int64_t{node.value()} + 1, ' ');
        if (mesh.labels.empty()) {
            nodes.point<D>(mesh.points[node]);
            continue;
        }
        for (int k = 0; k < D; ++k) {
            nodes.number(mesh.points[node][k], ' ');
        }
        nodes.number(mesh.labels[node], '\n');
    }
    TextFile elements(with_suffix(path, ".ele"));
    elements.number(mesh.elements.size(), ' ');
    elements.number(D + 1, ' ');
    elements.text("1\n");
    write_rows(elements, mesh.elements, mesh.region);
    TextFile faces(with_suffix(path, D == 3 ? ".face" : ".edge"));
    faces.number(mesh.faces.size(), ' ');
    faces.text("1\n");
    write_rows(faces, mesh.faces, mesh.patch);
    faces.patch_comments(comment, portable_names(mesh.patch_names, notes));
    nodes.commit();
    elements.commit();
    faces.commit();
    return notes;
}

template std::vector<std::string> write(const std::filesystem::path&, const Mesh<2>&,
                                        const WriteOptions&);
template std::vector<std::string> write(const std::filesystem::path&, const Mesh<3>&,
                                        const WriteOptions&);

} // namespace ameco::tetgen_files
