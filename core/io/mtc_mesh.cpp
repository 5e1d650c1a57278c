// SPDX-License-Identifier: AGPL-3.0-or-later
// The meta-file and the mesh of MTC.
#include "core/io/mtc.h"

#include "core/io/file_bytes.h"
#include "core/io/mixed_mesh.h"
#include "core/io/patch_names.h"
#include "core/io/text_file.h"
#include "core/io/text_scanner.h"
#include "core/mesh/boundary.h"
#include "core/mesh/simplex.h"

#include <algorithm>

namespace ameco::mtc {
namespace {

/// What a meta-file names.
struct Meta {
    std::filesystem::path mesh;
    std::filesystem::path metric;
};

Meta parse_meta(const Source& source) {
    Meta meta;
    std::string_view rest = source.bytes;
    for (std::size_t open = rest.find('{'); open != std::string_view::npos; open = rest.find('{')) {
        const std::size_t close = rest.find('}', open);
        const std::string_view entry =
            rest.substr(open + 1, close == std::string_view::npos ? close : close - open - 1);
        const std::size_t colon = entry.find(':');
        if (close == std::string_view::npos || colon == std::string_view::npos) {
            throw InputError(source.name + ": expected { M: file } or { Metrique: file }, found " +
                             in_quotes(entry));
        }
        const std::string_view key = without_blanks_around(entry.substr(0, colon));
        const std::filesystem::path file =
            source.path.parent_path() / std::string(without_blanks_around(entry.substr(colon + 1)));
        if (key == "M") {
            meta.mesh = file;
        } else if (key == "Metrique") {
            meta.metric = file;
        }
        rest.remove_prefix(close + 1);
    }
    return meta;
}

std::filesystem::path patch_path(const std::filesystem::path& mesh) {
    return mesh.string() + ".patches";
}

template <int D>
std::string counts_text(const Mesh<D>& mesh) {
    return std::to_string(mesh.points.size()) + " " + std::to_string(mesh.elements.size()) + " " +
           std::to_string(mesh.faces.size());
}

/// Reads the patches written beside a mesh. False if there are none, or they are of another mesh.
template <int D>
bool read_patches(const std::filesystem::path& path, Mesh<D>& mesh,
                  std::vector<std::string>& notes) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(path, ignored)) {
        return false;
    }
    try {
        const FileBytes bytes(path);
        TextScanner text(bytes.view(), path.string(), '#');
        const auto where = [] { return std::string(); };
        for (const std::size_t count :
             {mesh.points.size(), mesh.elements.size(), mesh.faces.size()}) {
            if (text.integer(where) != static_cast<std::int64_t>(count)) {
                throw InputError(path.string() + ": belongs to another mesh (its counts differ)");
            }
        }
        IdVector<FaceId, int> patch(mesh.faces.size());
        for (int& p : patch) {
            p = static_cast<int>(text.integer(where));
        }
        text.skip_blank(); // to the comments
        mesh.patch = std::move(patch);
        mesh.patch_names = names_in_comments(text.patch_comments());
        return true;
    } catch (const Error& error) {
        notes.emplace_back(error.what());
        return false;
    }
}

/// Gives each face the patch that `complete_boundary` finds for it; faces inside the domain get one
/// above them all.
template <int D>
void find_patches(Mesh<D>& mesh, std::vector<std::string>& notes) {
    Mesh<D> bare;
    bare.points = mesh.points;
    bare.elements = mesh.elements;
    // Nothing may be renumbered: nodes without element would be dropped.
    const BoundaryRepair repair = complete_boundary(bare);
    if (repair.orphans_removed > 0 || repair.faces_added == 0) {
        notes.emplace_back("the format has no patches: all faces are patch 0");
        return;
    }
    std::vector<std::pair<Facet<D>, int>> found;
    int next = 1;
    for (const FaceId f : bare.faces.ids()) {
        found.emplace_back(sorted(bare.faces[f]), bare.patch[f]);
        next = std::max(next, bare.patch[f] + 1);
    }
    std::sort(found.begin(), found.end());
    for (const FaceId f : mesh.faces.ids()) {
        const std::pair<Facet<D>, int> key(sorted(mesh.faces[f]), 0);
        const auto at = std::lower_bound(found.begin(), found.end(), key);
        mesh.patch[f] = at != found.end() && at->first == key.first ? at->second : next;
    }
    notes.push_back(
        "the format has no patches: " + std::to_string(distinct(mesh.patch.raw()).size()) +
        " were made, divided at edges sharper than 40 degrees");
}

template <int D>
class Reader {
public:
    Reader(TextScanner& text, std::int64_t nodes, std::int64_t elements)
        : text_(text), nodes_(nodes), elements_(elements) {}

    MixedMesh<D> read() {
        mixed_.points.resize(static_cast<std::size_t>(nodes_), Vec<D>::Zero());
        for (const NodeId node : mixed_.points.ids()) {
            for (int k = 0; k < D; ++k) {
                mixed_.points[node][k] =
                    text_.real([&] { return "node " + std::to_string(node.value() + 1) + ": "; });
            }
        }
        for (std::int64_t i = 0; i < elements_; ++i) {
            read_element(i);
        }
        return std::move(mixed_);
    }

private:
    void read_element(std::int64_t i) {
        const auto where = [&] { return "element " + std::to_string(i + 1) + ": "; };
        Simplex<D> s;
        for (int k = 0; k <= D; ++k) {
            const std::int64_t node = text_.integer(where);
            const bool ends_face = k == D && node == 0;
            if ((node < 1 && !ends_face) || node > nodes_) {
                text_.fail_here(where() + "uses node " + std::to_string(node) +
                                ", but the file has " + std::to_string(nodes_) + " nodes");
            }
            s[k] = NodeId(static_cast<std::int32_t>(node - 1));
        }
        const bool is_face = !s[D].valid();
        if constexpr (D == 3) {
            is_face ? mixed_.triangles.add({s[0], s[1], s[2]}, 0) : mixed_.tetrahedra.add(s, 0);
        } else {
            is_face ? mixed_.lines.add({s[0], s[1]}, 0) : mixed_.triangles.add(s, 0);
        }
    }

    TextScanner& text_;
    std::int64_t nodes_;
    std::int64_t elements_;
    MixedMesh<D> mixed_;
};

} // namespace

bool recognises_meta(std::string_view bytes) {
    const std::string_view text = without_blanks_around(bytes.substr(0, 4096));
    return !text.empty() && text.front() == '{' && text.find(':') != std::string_view::npos &&
           text.find("M:") != std::string_view::npos;
}

MeshFile read_meta(const Source& source) {
    const Meta meta = parse_meta(source);
    if (meta.mesh.empty()) {
        throw InputError(source.name + ": names no mesh; a line { M: file.t } is missing");
    }
    const FileBytes bytes(meta.mesh);
    MeshFile file = read({meta.mesh, meta.mesh.string(), bytes.view(), source.options, &bytes});
    file.format = "MTC meta-file, " + file.format;
    if (!meta.metric.empty()) {
        file.notes.push_back("its metric is " + meta.metric.string());
    }
    return file;
}

TensorFile read_meta_tensors(const Source& source) {
    const Meta meta = parse_meta(source);
    if (meta.metric.empty()) {
        throw InputError(source.name + ": names no metric; a line { Metrique: file } is missing");
    }
    const FileBytes bytes(meta.metric);
    return read_tensors({meta.metric, meta.metric.string(), bytes.view(), {}, &bytes});
}

MeshFile read(const Source& source) {
    TextScanner text(source.bytes, source.name, '\0');
    const auto where = [] { return std::string("first line: "); };
    const std::int64_t nodes = text.integer(where);
    const std::int64_t dimension = text.integer(where);
    const std::int64_t elements = text.integer(where);
    const std::int64_t per_element = text.integer(where);
    if ((dimension != 2 && dimension != 3) || per_element != dimension + 1) {
        text.fail_here("expected the counts 'nodes dimension elements nodes-per-element' of "
                       "triangles in 2-D or tetrahedra in 3-D; it is no mesh of MTC");
    }
    if (!text.has_room(nodes, dimension) || !text.has_room(elements, per_element)) {
        text.fail_room("the first line", std::max(nodes, elements));
    }
    MeshFile file;
    file.format = "MTC text";
    const FileContext context{source.name, 1, source.options.surfaces};
    if (dimension == 3) {
        finish_mesh(Reader<3>(text, nodes, elements).read(), context, file);
    } else {
        finish_mesh(Reader<2>(text, nodes, elements).read(), context, file);
    }
    std::visit(
        [&](auto& mesh) {
            if (!read_patches(patch_path(source.path), mesh, file.notes) && !mesh.faces.empty()) {
                find_patches(mesh, file.notes);
            }
        },
        file.mesh);
    return file;
}

namespace {

template <int D>
void write_patches(const std::filesystem::path& path, const Mesh<D>& mesh,
                   const std::map<int, std::string>& names) {
    TextFile file(path);
    file.text("# Patches of the faces of an MTC mesh, which has no place for them; by ameco\n");
    file.text(counts_text(mesh) + "\n");
    for (const int patch : mesh.patch) {
        file.number(patch, '\n');
    }
    file.patch_comments('#', names);
    file.commit();
}

} // namespace

template <int D>
std::vector<std::string> write(const std::filesystem::path& path, const Mesh<D>& mesh,
                               const WriteOptions&) {
    std::vector<std::string> notes;
    const std::map<int, std::string> names = portable_names(mesh.patch_names, notes);
    TextFile file(path);
    file.number(mesh.points.size(), ' ');
    file.number(D, ' ');
    file.number(mesh.elements.size() + mesh.faces.size(), ' ');
    file.number(D + 1, '\n');
    for (const Vec<D>& x : mesh.points) {
        file.point<D>(x);
    }
    for (const Simplex<D>& s : mesh.elements) {
        for (int k = 0; k <= D; ++k) {
            file.number(std::int64_t{s[k].value()} + 1, k < D ? ' ' : '\n');
        }
    }
    for (const Facet<D>& f : mesh.faces) {
        for (const NodeId node : f) {
            file.number(std::int64_t{node.value()} + 1, ' ');
        }
        file.text("0\n");
    }
    write_patches(patch_path(path), mesh, names);
    file.commit();
    if (!mesh.faces.empty()) {
        notes.push_back("patches are in " + patch_path(path).filename().string() +
                        ", since the format has no place for them");
    }
    return notes;
}

template <int D>
std::vector<std::string> write_meta(const std::filesystem::path& path, const Mesh<D>& mesh,
                                    const WriteOptions& options) {
    std::filesystem::path mesh_path = path;
    mesh_path.replace_extension(".t");
    std::vector<std::string> notes = write(mesh_path, mesh, options);
    TextFile file(path);
    file.text("{ M:          " + mesh_path.filename().string() + " }\n");
    if (!options.metric.empty()) {
        file.text("{ Metrique:   " + options.metric.string() + " }\n");
    }
    file.commit();
    return notes;
}

template std::vector<std::string> write(const std::filesystem::path&, const Mesh<2>&,
                                        const WriteOptions&);
template std::vector<std::string> write(const std::filesystem::path&, const Mesh<3>&,
                                        const WriteOptions&);
template std::vector<std::string> write_meta(const std::filesystem::path&, const Mesh<2>&,
                                             const WriteOptions&);
template std::vector<std::string> write_meta(const std::filesystem::path&, const Mesh<3>&,
                                             const WriteOptions&);

} // namespace ameco::mtc
