// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/su2.h"

#include "core/io/mixed_mesh.h"
#include "core/io/patch_names.h"
#include "core/io/text_file.h"
#include "core/io/text_scanner.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace ameco::su2 {
namespace {

constexpr char comment = '%';
/// Markers of the interfaces between processors, which are no boundary.
constexpr std::string_view send_receive = "SEND_RECEIVE";

/// A line `KEY= value`.
struct Entry {
    std::string_view key;
    std::string_view value; ///< up to a comment, without blanks around it
};

bool is_entry(std::string_view line) {
    return line.substr(0, line.find(comment)).find('=') != std::string_view::npos;
}

Entry take_entry(TextScanner& text) {
    std::string_view line = text.take_line();
    line = line.substr(0, line.find(comment));
    const std::size_t equals = line.find('=');
    return {without_blanks_around(line.substr(0, equals)),
            without_blanks_around(line.substr(equals + 1))};
}

/// The rest of the line is not taken.
bool stands_at_entry(const TextScanner& text) {
    const std::string_view rest(text.here(), static_cast<std::size_t>(text.left()));
    return is_entry(rest.substr(0, rest.find('\n')));
}

std::int64_t count_of(const TextScanner& text, const Entry& entry) {
    std::int64_t count = 0;
    const char* last = entry.value.data() + entry.value.size();
    const auto [rest, error] = std::from_chars(entry.value.data(), last, count);
    if (error != std::errc{} || (rest != last && !is_blank(*rest))) {
        text.fail_here(std::string(entry.key) + "= is followed by " + in_quotes(entry.value) +
                       " instead of a count");
    }
    return count;
}

/// Where a number is read, for messages.
struct Row {
    const char* key;
    std::int64_t index;
    std::int64_t count;
    std::string operator()() const {
        return std::string(key) + ", row " + std::to_string(index + 1) + " of " +
               std::to_string(count) + ": ";
    }
};

template <int D>
class Reader {
public:
    explicit Reader(const Source& source)
        : text_(source.bytes, source.name, comment, TextScanner::Rows::lines), source_(source) {}

    MeshFile read() {
        while (text_.next_row()) {
            if (stands_at_entry(text_)) {
                read_section(take_entry(text_));
            } else if (!skipping_) {
                text_.fail_here("expected a line KEY= value, found " + in_quotes(text_.token()) +
                                "; a count above is too small");
            }
        }
        name_patches();
        MeshFile file;
        file.format = "SU2";
        if (seen_.empty()) {
            throw InputError(source_.name + ": has no NELEM= section; it is not an SU2 mesh");
        }
        if (other_cells_ > 0) {
            file.notes.push_back("skipped " + std::to_string(other_cells_) +
                                 " points listed as cells of markers");
        }
        finish_mesh(std::move(mixed_), {source_.name, 0, source_.options.surfaces}, file);
        return file;
    }

private:
    void read_section(const Entry& entry) {
        skipping_ = false;
        if (entry.key == "NDIME" || entry.key == "NMARK") {
            return;
        }
        if (entry.key == "NZONE" && count_of(text_, entry) > 1) {
            text_.fail_here("the file holds " + std::string(entry.value) +
                            " zones; only files of one zone can be read: save each zone as a "
                            "file of its own");
        }
        if (entry.key == "NELEM") {
            refuse_second(entry);
            read_cells("NELEM", checked_count(entry, 4), 0, D);
        } else if (entry.key == "NPOIN") {
            refuse_second(entry);
            read_points(checked_count(entry, D));
        } else if (entry.key == "MARKER_TAG") {
            tags_.emplace_back(entry.value);
        } else if (entry.key == "MARKER_ELEMS") {
            read_marker(entry);
        } else {
            skipping_ = true; // what follows may be rows of a section we do not know
        }
    }

    void refuse_second(const Entry& entry) {
        if (std::find(seen_.begin(), seen_.end(), entry.key) != seen_.end()) {
            text_.fail_here(std::string(entry.key) + "= occurs a second time");
        }
        seen_.emplace_back(entry.key);
    }

    std::int64_t checked_count(const Entry& entry, std::int64_t numbers_per_row) const {
        const std::int64_t count = count_of(text_, entry);
        if (!text_.has_room(count, numbers_per_row)) {
            text_.fail_room(std::string(entry.key) + "=", count);
        }
        return count;
    }

    void read_points(std::int64_t count) {
        mixed_.points.reserve(static_cast<std::size_t>(count));
        for (std::int64_t i = 0; i < count; ++i) {
            const Row row{"NPOIN", i, count};
            require_row(row);
            Vec<D> x;
            for (int k = 0; k < D; ++k) {
                x[k] = text_.real(row);
            }
            mixed_.points.push_back(x);
        }
    }

    void require_row(const Row& row) {
        if (!text_.next_row()) {
            text_.fail_expected(row(), "a row");
        }
    }

    void read_marker(const Entry& entry) {
        if (tags_.empty()) {
            text_.fail_here("MARKER_ELEMS= stands before any MARKER_TAG=");
        }
        if (tags_.back() == send_receive) {
            skipping_ = true;
            tags_.pop_back();
            return;
        }
        read_cells("MARKER_ELEMS", checked_count(entry, 2), static_cast<int>(tags_.size()) - 1,
                   D - 1);
    }

    /// \param dimension  that the cells must have
    void read_cells(const char* key, std::int64_t count, int label, int dimension) {
        std::array<NodeId, 8> nodes;
        for (std::int64_t i = 0; i < count; ++i) {
            const Row row{key, i, count};
            require_row(row);
            const std::int64_t code = text_.integer(row);
            const CellTypeInfo* type = find_cell_type(&CellTypeInfo::vtk, code);
            if (code == 1 && dimension < D) {
                ++other_cells_;
                continue;
            }
            if (type == nullptr || type->dimension != dimension) {
                text_.fail_here(row() + "cells of the type " + std::to_string(code) +
                                " cannot stand here");
            }
            for (int k = 0; k < type->nodes; ++k) {
                const std::int64_t node = text_.integer(row);
                if (node < 0 || node > std::numeric_limits<std::int32_t>::max()) {
                    text_.fail_here(row() + "there is no node " + std::to_string(node));
                }
                nodes[static_cast<std::size_t>(k)] = NodeId(static_cast<std::int32_t>(node));
            }
            add_cell(mixed_, type->type, {nodes.data(), static_cast<std::size_t>(type->nodes)},
                     label);
        }
    }

    /// Until here, cells of markers are labelled with the place of their tag in `tags_`.
    void name_patches() {
        TaggedPatches tagged = patches_of(tags_, names_in_comments(text_.patch_comments()));
        const auto relabel = [&](std::vector<int>& labels) {
            for (int& label : labels) {
                label = tagged.patches[static_cast<std::size_t>(label)];
            }
        };
        if constexpr (D == 3) {
            relabel(mixed_.triangles.labels);
            relabel(mixed_.quadrilaterals.labels);
            mixed_.face_names = std::move(tagged.names);
        } else {
            relabel(mixed_.lines.labels);
            mixed_.line_names = std::move(tagged.names);
        }
    }

    TextScanner text_;
    const Source& source_;
    MixedMesh<D> mixed_;
    std::vector<std::string> tags_;
    std::vector<std::string> seen_;
    std::int64_t other_cells_ = 0;
    bool skipping_ = false; ///< in a section that is not known
};

/// NDIME= may stand anywhere, but the sections cannot be read without it.
std::int64_t find_dimension(const Source& source) {
    TextScanner text(source.bytes, source.name, comment, TextScanner::Rows::lines);
    while (text.next_row()) {
        if (text.token().substr(0, 5) == "NDIME" && stands_at_entry(text)) {
            const std::int64_t dimension = count_of(text, take_entry(text));
            if (dimension != 2 && dimension != 3) {
                text.fail_here("NDIME= is " + std::to_string(dimension) + ", but must be 2 or 3");
            }
            return dimension;
        }
    }
    throw InputError(source.name + ": has no line NDIME= 2 or NDIME= 3; it is damaged, or not an "
                                   "SU2 mesh");
}

template <std::size_t N>
void write_cell(TextFile& file, CellType type, const std::array<NodeId, N>& nodes, char behind) {
    file.number(info(type).vtk, ' ');
    for (std::size_t k = 0; k < N; ++k) {
        file.number(nodes[k].value(), k + 1 < N ? ' ' : behind);
    }
}

} // namespace

bool recognises(std::string_view bytes) {
    constexpr std::array<std::string_view, 5> keys{"NDIME", "NELEM", "NPOIN", "NMARK", "NZONE"};
    TextScanner text(bytes, "", comment, TextScanner::Rows::lines);
    return text.next_row() && stands_at_entry(text) &&
           std::any_of(keys.begin(), keys.end(), [&](std::string_view key) {
               return text.token().substr(0, key.size()) == key;
           });
}

MeshFile read(const Source& source) {
    return find_dimension(source) == 3 ? Reader<3>(source).read() : Reader<2>(source).read();
}

template <int D>
std::vector<std::string> write(const std::filesystem::path& path, const Mesh<D>& mesh,
                               const WriteOptions&) {
    constexpr CellType element_type = D == 3 ? CellType::tetrahedron : CellType::triangle;
    constexpr CellType face_type = D == 3 ? CellType::triangle : CellType::line;
    std::vector<std::string> notes;
    const std::vector<int> patches = distinct(mesh.patch.raw());
    const std::map<int, std::string> names = portable_names(mesh.patch_names, notes);
    const std::map<int, std::string> tags = tags_of(patches, names);
    TextFile file(path);
    file.patch_comments(comment, names);
    file.text("NDIME= ");
    file.number(D, '\n');
    file.text("NELEM= ");
    file.number(mesh.elements.size(), '\n');
    for (const ElementId e : mesh.elements.ids()) {
        write_cell(file, element_type, mesh.elements[e], ' ');
        file.number(e.value(), '\n');
    }
    file.text("NPOIN= ");
    file.number(mesh.points.size(), '\n');
    for (const NodeId node : mesh.points.ids()) {
        for (int k = 0; k < D; ++k) {
            file.number(mesh.points[node][k], ' ');
        }
        file.number(node.value(), '\n');
    }
    file.text("NMARK= ");
    file.number(patches.size(), '\n');
    std::map<int, std::vector<FaceId>> faces;
    for (const FaceId f : mesh.faces.ids()) {
        faces[mesh.patch[f]].push_back(f);
    }
    for (const auto& [patch, list] : faces) {
        file.text("MARKER_TAG= " + tags.at(patch) + "\nMARKER_ELEMS= ");
        file.number(list.size(), '\n');
        for (const FaceId f : list) {
            write_cell(file, face_type, mesh.faces[f], '\n');
        }
    }
    file.commit();
    return notes;
}

template std::vector<std::string> write(const std::filesystem::path&, const Mesh<2>&,
                                        const WriteOptions&);
template std::vector<std::string> write(const std::filesystem::path&, const Mesh<3>&,
                                        const WriteOptions&);

} // namespace ameco::su2
