// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/ugrid.h"

#include "core/io/binary_file.h"
#include "core/io/file_bytes.h"
#include "core/io/mapbc.h"
#include "core/io/mixed_mesh.h"
#include "core/io/patch_names.h"
#include "core/io/text_file.h"
#include "core/io/text_scanner.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace ameco::ugrid {
namespace {

struct Form {
    std::string_view suffix;
    bool binary;
    NumberLayout numbers;
    bool records; ///< of Fortran: the counts, and all the rest
};

constexpr std::array<Form, 13> forms{{{".b8.ugrid", true, {true, 4, 8}, false},
                                      {".lb8.ugrid", true, {false, 4, 8}, false},
                                      {".b4.ugrid", true, {true, 4, 4}, false},
                                      {".lb4.ugrid", true, {false, 4, 4}, false},
                                      {".r8.ugrid", true, {true, 4, 8}, true},
                                      {".lr8.ugrid", true, {false, 4, 8}, true},
                                      {".r4.ugrid", true, {true, 4, 4}, true},
                                      {".lr4.ugrid", true, {false, 4, 4}, true},
                                      {".b8l.ugrid", true, {true, 8, 8}, false},
                                      {".lb8l.ugrid", true, {false, 8, 8}, false},
                                      {".b8.ugrid64", true, {true, 8, 8}, false},
                                      {".lb8.ugrid64", true, {false, 8, 8}, false},
                                      {".ugrid", false, {}, false}}};

/// The first one that fits: the longer suffixes stand before ".ugrid".
const Form& form_of(const std::filesystem::path& path) {
    const std::string name = path.filename().string();
    for (const Form& form : forms) {
        if (name.size() >= form.suffix.size() &&
            name.compare(name.size() - form.suffix.size(), std::string::npos, form.suffix) == 0) {
            return form;
        }
    }
    return forms.back();
}

std::filesystem::path mapbc_path(const std::filesystem::path& path) {
    std::string name = path.filename().string();
    const Form& form = form_of(path);
    if (name.size() > form.suffix.size() && name.find(".ugrid") != std::string::npos) {
        name.resize(name.size() - form.suffix.size());
    }
    return path.parent_path() / (name + ".mapbc");
}

struct Counts {
    std::int64_t nodes, triangles, quadrilaterals, tetrahedra, pyramids, prisms, hexahedra;

    [[nodiscard]] bool possible() const {
        constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
        for (const std::int64_t n :
             {nodes, triangles, quadrilaterals, tetrahedra, pyramids, prisms, hexahedra}) {
            if (n < 0 || n > most) {
                return false;
            }
        }
        return nodes > 0;
    }
    [[nodiscard]] std::int64_t integers() const {
        return 4 * triangles + 5 * quadrilaterals + 4 * tetrahedra + 5 * pyramids + 6 * prisms +
               8 * hexahedra;
    }
};

std::int64_t body_bytes(const Counts& counts, const NumberLayout& numbers) {
    return 3 * counts.nodes * numbers.real_bytes + counts.integers() * numbers.int_bytes;
}

constexpr int count_number = 7;
constexpr int mark_bytes = 4;

bool is_swapped(const NumberLayout& numbers) {
    return numbers.big_endian != (std::endian::native == std::endian::big);
}

/// Reads the numbers of the binary forms.
class BinarySource {
public:
    BinarySource(std::string_view bytes, const Form& form)
        : cursor_(bytes.data(), is_swapped(form.numbers), form.numbers.int_bytes,
                  form.numbers.real_bytes),
          form_(form) {
        skip_mark();
        Counts& c = counts_;
        for (std::int64_t* n : {&c.nodes, &c.triangles, &c.quadrilaterals, &c.tetrahedra,
                                &c.pyramids, &c.prisms, &c.hexahedra}) {
            *n = cursor_.integer();
        }
        skip_mark();
        skip_mark();
    }
    [[nodiscard]] const Counts& counts() const { return counts_; }
    std::int64_t integer(const char*, std::int64_t) { return cursor_.integer(); }
    double real(const char*, std::int64_t) { return cursor_.real(); }

private:
    void skip_mark() { cursor_.skip(form_.records ? mark_bytes : 0); }

    NumberCursor cursor_;
    const Form& form_;
    Counts counts_{};
};

/// Reads the numbers of the text form.
class TextSource {
public:
    TextSource(std::string_view bytes, const std::string& name) : text_(bytes, name, '\0') {
        Counts& c = counts_;
        std::int64_t i = 0;
        for (std::int64_t* n : {&c.nodes, &c.triangles, &c.quadrilaterals, &c.tetrahedra,
                                &c.pyramids, &c.prisms, &c.hexahedra}) {
            *n = integer("count", i++);
        }
        if (!c.possible() || !text_.has_room(1, 3 * c.nodes + c.integers())) {
            text_.fail_here("the counts in the first line need more numbers than the file has "
                            "room for; it is truncated, damaged, or not UGRID");
        }
    }
    [[nodiscard]] const Counts& counts() const { return counts_; }
    std::int64_t integer(const char* what, std::int64_t row) {
        return text_.integer([&] { return where(what, row); });
    }
    double real(const char* what, std::int64_t row) {
        return text_.real([&] { return where(what, row); });
    }

private:
    static std::string where(const char* what, std::int64_t row) {
        return std::string(what) + " " + std::to_string(row + 1) + ": ";
    }
    TextScanner text_;
    Counts counts_{};
};

template <class Numbers>
class Reader {
public:
    Reader(Numbers& numbers, const std::string& name) : numbers_(numbers), name_(name) {}

    MixedMesh<3> read() {
        const Counts& c = numbers_.counts();
        mixed_.points.resize(static_cast<std::size_t>(c.nodes), Vec<3>::Zero());
        for (const NodeId node : mixed_.points.ids()) {
            for (int k = 0; k < 3; ++k) {
                mixed_.points[node][k] = numbers_.real("node", node.value());
            }
        }
        read_nodes(mixed_.triangles, c.triangles, "triangle");
        read_nodes(mixed_.quadrilaterals, c.quadrilaterals, "quadrilateral");
        read_patches(mixed_.triangles.labels);
        read_patches(mixed_.quadrilaterals.labels);
        read_nodes(mixed_.tetrahedra, c.tetrahedra, "tetrahedron");
        read_nodes(mixed_.pyramids, c.pyramids, "pyramid");
        for (auto& p : mixed_.pyramids.nodes) {
            p = {p[0], p[3], p[4], p[1], p[2]};
        }
        read_nodes(mixed_.prisms, c.prisms, "prism");
        read_nodes(mixed_.hexahedra, c.hexahedra, "hexahedron");
        return std::move(mixed_);
    }

private:
    template <std::size_t N>
    void read_nodes(Cells<N>& cells, std::int64_t count, const char* what) {
        cells.resize(static_cast<std::size_t>(count));
        const std::int64_t last = numbers_.counts().nodes;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            for (NodeId& node : cells.nodes[i]) {
                const std::int64_t number = numbers_.integer(what, static_cast<std::int64_t>(i));
                if (number < 1 || number > last) {
                    throw InputError(name_ + ": " + what + " " + std::to_string(i + 1) +
                                     " uses node " + std::to_string(number) +
                                     ", but the file has " + std::to_string(last) + " nodes");
                }
                node = NodeId(static_cast<std::int32_t>(number - 1));
            }
        }
    }
    void read_patches(std::vector<int>& labels) {
        for (std::size_t i = 0; i < labels.size(); ++i) {
            const std::int64_t label =
                numbers_.integer("patch of boundary face", static_cast<std::int64_t>(i));
            if (label != static_cast<std::int32_t>(label)) {
                throw InputError(name_ + ": the patch of boundary face " + std::to_string(i + 1) +
                                 " is " + std::to_string(label) +
                                 "; numbers of patches must fit into 32 bits: renumber them");
            }
            labels[i] = static_cast<int>(label);
        }
    }

    Numbers& numbers_;
    const std::string& name_;
    MixedMesh<3> mixed_;
};

/// Bytes of the whole file if its counts make sense in this form.
std::optional<std::int64_t> expected_size(std::string_view bytes, const Form& form) {
    const std::int64_t header =
        count_number * form.numbers.int_bytes + (form.records ? 4 * mark_bytes : 0);
    if (static_cast<std::int64_t>(bytes.size()) < header) {
        return std::nullopt;
    }
    const Counts counts = BinarySource(bytes, form).counts();
    if (!counts.possible()) {
        return std::nullopt;
    }
    return header + body_bytes(counts, form.numbers);
}

bool looks_like_text(std::string_view bytes) {
    constexpr std::string_view in_numbers = "0123456789+-.eEdD";
    const std::string_view begin = bytes.substr(0, 64);
    return std::all_of(begin.begin(), begin.end(), [&](char c) {
        return is_blank(c) || in_numbers.find(c) != std::string_view::npos;
    });
}

/// The form whose size agrees with the file's; else that of the suffix with something behind it.
const Form& detect_form(const Source& source) {
    const Form& named = form_of(source.path);
    if (looks_like_text(source.bytes)) {
        return forms.back();
    }
    const auto size = static_cast<std::int64_t>(source.bytes.size());
    if (named.binary && expected_size(source.bytes, named) == size) {
        return named;
    }
    for (const Form& form : forms) {
        if (form.binary && expected_size(source.bytes, form) == size) {
            return form;
        }
    }
    const std::optional<std::int64_t> expected =
        named.binary ? expected_size(source.bytes, named) : std::nullopt;
    if (expected && *expected < size) {
        return named;
    }
    throw InputError(source.name + ": its " + std::to_string(size) +
                     " bytes do not agree with the counts at its beginning" +
                     (expected ? ", which need " + std::to_string(*expected) : "") +
                     "; it is truncated, damaged, or not UGRID");
}

std::string describe(const Form& form) {
    if (!form.binary) {
        return "UGRID text";
    }
    return std::string("UGRID binary, ") +
           (form.numbers.big_endian ? "big-endian" : "little-endian") + ", " +
           std::to_string(8 * form.numbers.real_bytes) + "-bit coordinates" +
           (form.numbers.int_bytes == 8 ? ", 64-bit integers" : "") +
           (form.records ? ", Fortran records" : "");
}

void read_names(const Source& source, MeshFile& file) {
    const std::filesystem::path path = mapbc_path(source.path);
    std::error_code ignored;
    auto* mesh = std::get_if<Mesh<3>>(&file.mesh);
    if (mesh == nullptr || !std::filesystem::is_regular_file(path, ignored)) {
        return;
    }
    try {
        const FileBytes bytes(path);
        for (auto& [id, patch] : mapbc::read(bytes.view(), path.string())) {
            if (!patch.name.empty()) {
                mesh->patch_names[id] = patch.name;
            }
        }
    } catch (const Error& error) {
        file.notes.push_back(std::string("patches have no names, since ") + error.what());
    }
}

} // namespace

MeshFile read(const Source& source) {
    const Form& form = detect_form(source);
    MixedMesh<3> mixed;
    if (form.binary) {
        BinarySource numbers(source.bytes, form);
        mixed = Reader<BinarySource>(numbers, source.name).read();
    } else {
        TextSource numbers(source.bytes, source.name);
        mixed = Reader<TextSource>(numbers, source.name).read();
    }
    MeshFile file;
    file.format = describe(form);
    finish_mesh(std::move(mixed), {source.name, 1, source.options.surfaces}, file);
    read_names(source, file);
    return file;
}

namespace {

/// The numbers of boundary conditions in a file that is there already are kept: they cannot be
/// known from a mesh.
void write_names(const std::filesystem::path& path, const Mesh<3>& mesh,
                 std::vector<std::string>& notes) {
    const std::map<int, std::string> names = portable_names(mesh.patch_names, notes);
    std::map<int, mapbc::Patch> patches;
    std::error_code ignored;
    if (std::filesystem::is_regular_file(path, ignored)) {
        try {
            const FileBytes bytes(path);
            patches = mapbc::read(bytes.view(), path.string());
        } catch (const Error&) {
            patches.clear(); // what cannot be read is not kept
        }
    }
    std::map<int, mapbc::Patch> kept;
    for (const auto& [id, name] : names) {
        kept[id] = {patches.contains(id) ? patches[id].condition : 0, name};
    }
    for (const int id : distinct(mesh.patch.raw())) {
        kept.emplace(id, mapbc::Patch{patches.contains(id) ? patches[id].condition : 0, ""});
    }
    mapbc::write(path, kept);
    notes.push_back("names of patches are in " + path.filename().string() +
                    ", whose numbers of boundary conditions are to be set");
}

Counts counts_of(const Mesh<3>& mesh) {
    const auto size = [](const auto& list) { return static_cast<std::int64_t>(list.size()); };
    return {size(mesh.points), size(mesh.faces), 0, size(mesh.elements), 0, 0, 0};
}

void write_text(const std::filesystem::path& path, const Mesh<3>& mesh) {
    TextFile file(path);
    for (const std::size_t n : {mesh.points.size(), mesh.faces.size(), std::size_t{0},
                                mesh.elements.size(), std::size_t{0}, std::size_t{0}}) {
        file.number(n, ' ');
    }
    file.number(0, '\n');
    for (const Vec<3>& x : mesh.points) {
        file.point<3>(x);
    }
    const auto write_cells = [&](const auto& cells) {
        for (const auto& nodes : cells) {
            for (std::size_t k = 0; k < nodes.size(); ++k) {
                file.number(std::int64_t{nodes[k].value()} + 1, k + 1 < nodes.size() ? ' ' : '\n');
            }
        }
    };
    write_cells(mesh.faces);
    for (const int patch : mesh.patch) {
        file.number(patch, '\n');
    }
    write_cells(mesh.elements);
    file.commit();
}

void write_binary(const std::filesystem::path& path, const Form& form, const Mesh<3>& mesh) {
    const Counts c = counts_of(mesh);
    BinaryFile file(path, form.numbers);
    const auto mark = [&](std::int64_t bytes) {
        if (form.records) {
            file.record_mark(bytes);
        }
    };
    mark(count_number * form.numbers.int_bytes);
    for (const std::int64_t n : {c.nodes, c.triangles, c.quadrilaterals, c.tetrahedra, c.pyramids,
                                 c.prisms, c.hexahedra}) {
        file.integer(n);
    }
    mark(count_number * form.numbers.int_bytes);
    mark(body_bytes(c, form.numbers));
    for (const Vec<3>& x : mesh.points) {
        for (int k = 0; k < 3; ++k) {
            file.real(x[k]);
        }
    }
    const auto write_cells = [&](const auto& cells) {
        for (const auto& nodes : cells) {
            for (const NodeId node : nodes) {
                file.integer(std::int64_t{node.value()} + 1);
            }
        }
    };
    write_cells(mesh.faces);
    for (const int patch : mesh.patch) {
        file.integer(patch);
    }
    write_cells(mesh.elements);
    mark(body_bytes(c, form.numbers));
    file.commit();
}

} // namespace

std::vector<std::string> write(const std::filesystem::path& path, const Mesh<3>& mesh,
                               const WriteOptions&) {
    const Form& form = form_of(path);
    std::vector<std::string> notes;
    if (form.records) {
        if (body_bytes(counts_of(mesh), form.numbers) > std::numeric_limits<std::int32_t>::max()) {
            throw UsageError(path.string() +
                             ": a record of Fortran ends at 2 GiB; write .b8.ugrid or .lb8.ugrid");
        }
    }
    if (form.binary) {
        write_binary(path, form, mesh);
    } else {
        write_text(path, mesh);
    }
    if (form.numbers.real_bytes == 4) {
        notes.emplace_back("coordinates were rounded to single precision");
    }
    if (!mesh.patch_names.empty()) {
        write_names(mapbc_path(path), mesh, notes);
    }
    return notes;
}

} // namespace ameco::ugrid
