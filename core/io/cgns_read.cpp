// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/cgns.h"

#include "core/io/cgns_library.h"
#include "core/io/mixed_mesh.h"
#include "core/io/patch_names.h"
#include "core/io/trial_run.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>

namespace ameco::cgns {
namespace {

/// Kinds of second order, whose first nodes are the corners.
CellType linear_type(ElementType_t type, const File& file) {
    switch (type) {
    case BAR_3:
        return CellType::line;
    case TRI_6:
        return CellType::triangle;
    case QUAD_8:
    case QUAD_9:
        return CellType::quadrilateral;
    case TETRA_10:
        return CellType::tetrahedron;
    case PYRA_13:
    case PYRA_14:
        return CellType::pyramid;
    case PENTA_15:
    case PENTA_18:
        return CellType::prism;
    case HEXA_20:
    case HEXA_27:
        return CellType::hexahedron;
    default:
        break;
    }
    if (const CellTypeInfo* info = find_cell_type(&CellTypeInfo::cgns, type)) {
        return info->type;
    }
    file.fail(std::string("elements of the kind ") + cg_ElementTypeName(type) +
              " cannot be read; write tetrahedra, pyramids, prisms and hexahedra");
}

struct Section {
    char name[name_length + 1] = {};
    ElementType_t type = ElementTypeNull;
    cgsize_t first = 0;
    cgsize_t last = 0;
    int number = 0;
};

/// A cell of the boundary, with its number in the file.
struct BoundaryCell {
    cgsize_t number;
    CellType type;
    std::array<NodeId, 4> nodes;
    int tag; ///< place in the list of tags
};

/// Reads one zone of a mesh in D dimensions of space.
template <int D>
class Reader {
public:
    Reader(const Source& source, File& file, int cell_dimension)
        : source_(source), file_(file), cell_dimension_(cell_dimension) {}

    MeshFile read() {
        read_zone();
        read_points();
        int sections = 0;
        file_.require(cg_nsections(file_.id(), 1, 1, &sections), "its sections cannot be counted");
        for (int s = 1; s <= sections; ++s) {
            read_section(s);
        }
        read_conditions();
        add_boundary();
        MeshFile result;
        if (curved_) {
            result.changes.emplace_back("elements of second order were taken as straight ones; "
                                        "their middle nodes are left unused");
        }
        finish_mesh(std::move(mixed_), {source_.name, 1, source_.options.surfaces}, result);
        return result;
    }

private:
    /// Before memory is asked for: a damaged file may announce anything.
    void require_plausible(std::int64_t numbers, const char* what) const {
        const auto bytes = static_cast<std::int64_t>(source_.bytes.size());
        if (numbers < 0 || numbers > bytes) {
            file_.fail(std::string("announces ") + std::to_string(numbers) + " " + what +
                       ", more than its " + std::to_string(bytes) +
                       " bytes can hold; it is damaged");
        }
    }

    void read_zone() {
        int zones = 0;
        file_.require(cg_nzones(file_.id(), 1, &zones), "its zones cannot be counted");
        if (zones != 1) {
            file_.fail("holds " + std::to_string(zones) +
                       " zones; only files of one zone can be read: join them first");
        }
        ZoneType_t type = ZoneTypeNull;
        file_.require(cg_zone_type(file_.id(), 1, 1, &type), "its zone cannot be read");
        if (type != Unstructured) {
            file_.fail("its zone is structured; only unstructured zones can be read");
        }
        char name[name_length + 1];
        cgsize_t size[9] = {};
        file_.require(cg_zone_read(file_.id(), 1, 1, name, size), "its zone cannot be read");
        nodes_ = size[0];
        require_plausible(nodes_, "nodes");
        if (nodes_ < 1) {
            file_.fail("its zone has no nodes");
        }
    }

    void read_points() {
        int coordinates = 0;
        file_.require(cg_ncoords(file_.id(), 1, 1, &coordinates), "it has no coordinates");
        if (coordinates < D) {
            file_.fail("has " + std::to_string(coordinates) + " coordinates per node instead of " +
                       std::to_string(D));
        }
        mixed_.points.resize(static_cast<std::size_t>(nodes_), Vec<D>::Zero());
        std::vector<double> values(static_cast<std::size_t>(nodes_));
        constexpr std::array<const char*, 3> names{"CoordinateX", "CoordinateY", "CoordinateZ"};
        for (int k = 0; k < D; ++k) {
            const cgsize_t first = 1;
            file_.require(cg_coord_read(file_.id(), 1, 1, names[static_cast<std::size_t>(k)],
                                        RealDouble, &first, &nodes_, values.data()),
                          "its coordinates cannot be read");
            for (const NodeId node : mixed_.points.ids()) {
                mixed_.points[node][k] = values[node.index()];
            }
        }
    }

    void read_section(int number) {
        Section s;
        s.number = number;
        int boundary = 0;
        int parents = 0;
        file_.require(cg_section_read(file_.id(), 1, 1, number, s.name, &s.type, &s.first, &s.last,
                                      &boundary, &parents),
                      "section " + std::to_string(number) + " cannot be read");
        cgsize_t size = 0;
        file_.require(cg_ElementDataSize(file_.id(), 1, 1, number, &size),
                      std::string("the size of section ") + s.name + " cannot be read");
        require_plausible(size, "numbers of nodes");
        if (s.type == NODE) {
            return;
        }
        if (s.type == NGON_n || s.type == NFACE_n) {
            file_.fail(std::string("section ") + s.name +
                       " holds polyhedra; only meshes of tetrahedra, pyramids, prisms and "
                       "hexahedra can be read");
        }
        const std::int64_t count = std::int64_t{s.last} - s.first + 1;
        require_plausible(count, "elements");
        // One more, since some versions of libcgns write behind the last number.
        std::vector<cgsize_t> data(static_cast<std::size_t>(size) + 1);
        section_tag_ = -1;
        if (s.type == MIXED) {
            std::vector<cgsize_t> offsets(static_cast<std::size_t>(count) + 1);
            file_.require(cg_poly_elements_read(file_.id(), 1, 1, number, data.data(),
                                                offsets.data(), nullptr),
                          std::string("section ") + s.name + " cannot be read");
        } else {
            file_.require(cg_elements_read(file_.id(), 1, 1, number, data.data(), nullptr),
                          std::string("section ") + s.name + " cannot be read");
        }
        data.resize(static_cast<std::size_t>(size));
        take_cells(s, count, data);
    }

    void take_cells(const Section& s, std::int64_t count, const std::vector<cgsize_t>& data) {
        std::size_t at = 0;
        for (std::int64_t i = 0; i < count; ++i) {
            ElementType_t type = s.type;
            if (s.type == MIXED) {
                type = at < data.size() ? static_cast<ElementType_t>(data[at]) : ElementTypeNull;
                ++at;
                if (type == NODE) {
                    ++at;
                    continue;
                }
            }
            const CellType kind = linear_type(type, file_);
            int nodes = 0;
            file_.require(cg_npe(type, &nodes), "an element is of no known kind");
            if (at + static_cast<std::size_t>(nodes) > data.size()) {
                file_.fail(std::string("section ") + s.name + " is shorter than it says");
            }
            add(s, kind, s.first + static_cast<cgsize_t>(i), data.data() + at);
            curved_ = curved_ || nodes != info(kind).nodes;
            at += static_cast<std::size_t>(nodes);
        }
    }

    void add(const Section& s, CellType kind, cgsize_t number, const cgsize_t* given) {
        std::array<NodeId, 8> nodes;
        const int count = info(kind).nodes;
        for (int k = 0; k < count; ++k) {
            if (given[k] < 1 || given[k] > nodes_) {
                file_.fail("element " + std::to_string(number) + " uses node " +
                           std::to_string(given[k]) + ", but the file has " +
                           std::to_string(nodes_) + " nodes");
            }
            nodes[static_cast<std::size_t>(k)] = NodeId(static_cast<std::int32_t>(given[k] - 1));
        }
        if (info(kind).dimension == cell_dimension_) {
            add_cell(mixed_, kind, {nodes.data(), static_cast<std::size_t>(count)}, 0);
        } else if (info(kind).dimension == cell_dimension_ - 1) {
            if (section_tag_ < 0) {
                section_tag_ = tag_of(s.name);
            }
            BoundaryCell cell{number, kind, {}, section_tag_};
            std::copy_n(nodes.begin(), 4, cell.nodes.begin());
            boundary_.push_back(cell);
        }
    }

    int tag_of(const std::string& name) {
        const auto found = std::find(tags_.begin(), tags_.end(), name);
        if (found != tags_.end()) {
            return static_cast<int>(found - tags_.begin());
        }
        tags_.push_back(name);
        return static_cast<int>(tags_.size()) - 1;
    }

    void read_conditions() {
        std::sort(boundary_.begin(), boundary_.end(),
                  [](const auto& a, const auto& b) { return a.number < b.number; });
        int conditions = 0;
        if (cg_nbocos(file_.id(), 1, 1, &conditions) != CG_OK) {
            return;
        }
        for (int c = 1; c <= conditions; ++c) {
            read_condition(c);
        }
    }

    void read_condition(int c) {
        char name[name_length + 1] = {};
        BCType_t type = BCTypeNull;
        PointSetType_t set = PointSetTypeNull;
        cgsize_t count = 0;
        int normal_index[3] = {};
        cgsize_t normals = 0;
        DataType_t normal_type = DataTypeNull;
        int data_sets = 0;
        file_.require(cg_boco_info(file_.id(), 1, 1, c, name, &type, &set, &count, normal_index,
                                   &normals, &normal_type, &data_sets),
                      "boundary condition " + std::to_string(c) + " cannot be read");
        require_plausible(count, "points of a boundary condition");
        GridLocation_t location = Vertex;
        cg_boco_gridlocation_read(file_.id(), 1, 1, c, &location);
        std::vector<cgsize_t> points(static_cast<std::size_t>(count));
        file_.require(cg_boco_read(file_.id(), 1, 1, c, points.data(), nullptr),
                      "boundary condition " + std::to_string(c) + " cannot be read");
        const int tag = tag_of(name_of_condition(c, name));
        const bool range = set == PointRange || set == ElementRange;
        const bool by_nodes = location == Vertex && (set == PointRange || set == PointList);
        if (range && points.size() == 2) {
            mark_range(points[0], points[1], by_nodes, tag);
        } else if (!range) {
            std::sort(points.begin(), points.end());
            mark_list(points, by_nodes, tag);
        }
    }

    /// The name of its family, or its own; and what our descriptor says of it.
    std::string name_of_condition(int c, const char* own) {
        std::string name = own;
        if (cg_goto(file_.id(), 1, "Zone_t", 1, "ZoneBC_t", 1, "BC_t", c, "end") != CG_OK) {
            return name;
        }
        char family[20 * (name_length + 1) + 1] = {};
        if (cg_famname_read(family) == CG_OK && family[0] != '\0') {
            name = family;
        }
        int descriptors = 0;
        cg_ndescriptors(&descriptors);
        for (int d = 1; d <= descriptors; ++d) {
            char descriptor[name_length + 1] = {};
            char* text = nullptr;
            if (cg_descriptor_read(d, descriptor, &text) != CG_OK) {
                continue;
            }
            if (descriptor == std::string(patch_descriptor)) {
                remember_patch(name, text);
            }
            cg_free(text);
        }
        return name;
    }

    /// \param text  number of the patch, and its name if it has one
    void remember_patch(const std::string& tag, const std::string& text) {
        int number = 0;
        const char* last = text.data() + text.size();
        const auto [rest, error] = std::from_chars(text.data(), last, number);
        if (error == std::errc{}) {
            known_[tag] = {number, rest == last ? "" : std::string(rest + 1, last)};
        }
    }

    void mark_range(cgsize_t first, cgsize_t last, bool by_nodes, int tag) {
        for (BoundaryCell& cell : boundary_) {
            const auto inside = [&](std::int64_t i) { return i >= first && i <= last; };
            if (by_nodes ? all_nodes(cell, [&](NodeId n) { return inside(n.value() + 1); })
                         : inside(cell.number)) {
                cell.tag = tag;
            }
        }
    }
    void mark_list(const std::vector<cgsize_t>& points, bool by_nodes, int tag) {
        for (BoundaryCell& cell : boundary_) {
            const auto inside = [&](cgsize_t i) {
                return std::binary_search(points.begin(), points.end(), i);
            };
            if (by_nodes ? all_nodes(cell, [&](NodeId n) { return inside(n.value() + 1); })
                         : inside(cell.number)) {
                cell.tag = tag;
            }
        }
    }
    template <class F>
    static bool all_nodes(const BoundaryCell& cell, F&& f) {
        const auto count = static_cast<std::ptrdiff_t>(info(cell.type).nodes);
        return std::all_of(cell.nodes.begin(), cell.nodes.begin() + count, f);
    }

    void add_boundary() {
        // Tags that no cell kept (the name of a section whose cells all have conditions) are none.
        std::vector<bool> used(tags_.size(), false);
        for (const BoundaryCell& cell : boundary_) {
            used[static_cast<std::size_t>(cell.tag)] = true;
        }
        std::vector<std::string> foreign;
        std::map<int, std::string> names;
        for (std::size_t t = 0; t < tags_.size(); ++t) {
            const auto known = known_.find(tags_[t]);
            if (known != known_.end()) {
                names[known->second.first] = known->second.second;
            } else if (used[t]) {
                foreign.push_back(tags_[t]);
            }
        }
        TaggedPatches tagged = patches_of(foreign, names);
        std::vector<int> patch(tags_.size(), 0);
        std::size_t next = 0;
        for (std::size_t t = 0; t < tags_.size(); ++t) {
            const auto known = known_.find(tags_[t]);
            patch[t] = known != known_.end() ? known->second.first
                       : used[t]             ? tagged.patches[next++]
                                             : 0;
        }
        std::erase_if(tagged.names, [](const auto& entry) { return entry.second.empty(); });
        for (const BoundaryCell& cell : boundary_) {
            add_cell(mixed_, cell.type,
                     {cell.nodes.data(), static_cast<std::size_t>(info(cell.type).nodes)},
                     patch[static_cast<std::size_t>(cell.tag)]);
        }
        (cell_dimension_ == 3 ? mixed_.face_names : mixed_.line_names) = std::move(tagged.names);
    }

    const Source& source_;
    File& file_;
    int cell_dimension_;
    cgsize_t nodes_ = 0;
    MixedMesh<D> mixed_;
    std::vector<BoundaryCell> boundary_;
    std::vector<std::string> tags_;
    int section_tag_ = -1; ///< of the section that is read; -1 before its first cell
    std::map<std::string, std::pair<int, std::string>> known_; ///< what descriptors say of tags
    bool curved_ = false;
};

} // namespace

bool recognises(std::string_view bytes) {
    constexpr std::string_view adf = "ADF Database";
    return bytes.substr(0, 16).find(adf) == 4 || bytes.substr(0, 8) == "\x89HDF\r\n\x1a\n";
}

namespace {

MeshFile read_now(const Source& source) {
    File file(source.path, CG_MODE_READ, source.name);
    int bases = 0;
    file.require(cg_nbases(file.id(), &bases), "its bases cannot be counted");
    if (bases < 1) {
        file.fail("holds no base; it is no CGNS mesh");
    }
    char name[name_length + 1] = {};
    int cell_dimension = 0;
    int space_dimension = 0;
    file.require(cg_base_read(file.id(), 1, name, &cell_dimension, &space_dimension),
                 "its base cannot be read");
    int container = CG_FILE_NONE;
    cg_get_file_type(file.id(), &container);
    if (space_dimension != 2 && space_dimension != 3) {
        file.fail("its space has " + std::to_string(space_dimension) +
                  " dimensions; only 2 and 3 can be read");
    }
    MeshFile result = space_dimension == 3 ? Reader<3>(source, file, cell_dimension).read()
                                           : Reader<2>(source, file, cell_dimension).read();
    result.format = container == CG_FILE_HDF5 ? "CGNS, HDF5" : "CGNS, ADF";
    if (bases > 1) {
        result.notes.push_back("read the first of " + std::to_string(bases) + " bases");
    }
    return result;
}

} // namespace

MeshFile read(const Source& source) {
    if (source.options.from_memory) {
        throw InputError(source.name + ": holds a compressed CGNS file, which libcgns cannot read; "
                                       "unpack it first");
    }
    require_survival(source.name, "libcgns", {static_cast<std::int64_t>(source.bytes.size())},
                     [&] { static_cast<void>(read_now(source)); });
    return read_now(source);
}

} // namespace ameco::cgns
