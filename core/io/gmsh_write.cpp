// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/gmsh.h"

#include "core/io/cell_type.h"
#include "core/io/gmsh_comment.h"
#include "core/io/patch_names.h"
#include "core/io/text_file.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace ameco::gmsh {
namespace {

/// The cells of one dimension.
struct Group {
    CellType type;
    std::span<const NodeId> nodes; ///< [labels.size() * nodes per cell]
    std::span<const int> labels;
    std::int64_t first_tag; ///< of the elements in the file

    [[nodiscard]] int dimension() const { return info(type).dimension; }
    [[nodiscard]] std::size_t per_cell() const {
        return static_cast<std::size_t>(info(type).nodes);
    }
};

/// Numbers one behind the other, as text with blanks or in binary form.
class Numbers {
public:
    Numbers(const std::filesystem::path& path, Form form)
        : file_(path), binary_(form == Form::binary) {}

    void line(std::string_view text) { file_.text(std::string(text) + "\n"); }
    void integer(std::int64_t value, bool ends_row = false) {
        put(static_cast<std::int32_t>(value), ends_row);
    }
    void large_integer(std::int64_t value, bool ends_row = false) { put(value, ends_row); }
    void real(double value, bool ends_row = false) { put(value, ends_row); }
    void point(const Vec<3>& x) {
        for (int k = 0; k < 3; ++k) {
            real(x[k], k == 2);
        }
    }
    /// At the end of binary data.
    void end_data() {
        if (binary_) {
            file_.text("\n");
        }
    }
    [[nodiscard]] bool binary() const { return binary_; }
    void commit() { file_.commit(); }

private:
    template <class T>
    void put(T value, bool ends_row) {
        if (binary_) {
            file_.bytes(&value, sizeof(T));
        } else {
            file_.number(value, ends_row ? '\n' : ' ');
        }
    }
    TextFile file_;
    bool binary_;
};

template <int D>
Vec<3> in_space(const Vec<D>& x) {
    Vec<3> result = Vec<3>::Zero();
    result.template head<D>() = x;
    return result;
}

template <std::size_t N>
std::span<const NodeId> flat(const std::vector<std::array<NodeId, N>>& cells) {
    return {cells.empty() ? nullptr : cells.data()->data(), cells.size() * N};
}

/// Curves, faces and elements, without what is empty.
template <int D>
std::vector<Group> groups_of(const Mesh<D>& mesh) {
    std::vector<Group> groups;
    std::int64_t next = 1;
    const auto add = [&](CellType type, std::span<const NodeId> nodes,
                         const std::vector<int>& labels) {
        if (!labels.empty()) {
            groups.push_back({type, nodes, labels, next});
            next += static_cast<std::int64_t>(labels.size());
        }
    };
    if constexpr (D == 3) {
        add(CellType::line, flat(mesh.features.edges), mesh.features.edge_labels);
        add(CellType::triangle, flat(mesh.faces.raw()), mesh.patch.raw());
        add(CellType::tetrahedron, flat(mesh.elements.raw()), mesh.region.raw());
    } else {
        add(CellType::line, flat(mesh.faces.raw()), mesh.patch.raw());
        add(CellType::triangle, flat(mesh.elements.raw()), mesh.region.raw());
    }
    return groups;
}

std::int64_t cells_in(const std::vector<Group>& groups) {
    std::int64_t count = 0;
    for (const Group& group : groups) {
        count += static_cast<std::int64_t>(group.labels.size());
    }
    return count;
}

void write_header(Numbers& out, const char* version) {
    out.line("$MeshFormat");
    out.line(std::string(version) + (out.binary() ? " 1 8" : " 0 8"));
    if (out.binary()) {
        out.integer(1);
        out.end_data();
    }
    out.line("$EndMeshFormat");
}

void write_comment(Numbers& out, const std::vector<Group>& groups) {
    const bool needed = std::any_of(groups.begin(), groups.end(), [](const Group& group) {
        return std::all_of(group.labels.begin(), group.labels.end(),
                           [](int label) { return label == 0; });
    });
    if (needed) {
        out.line("$Comments");
        out.line(zero_labels_comment);
        out.line("$EndComments");
    }
}

void write_names(Numbers& out, int dimension, const std::map<int, std::string>& names) {
    if (names.empty()) {
        return;
    }
    out.line("$PhysicalNames");
    out.line(std::to_string(names.size()));
    for (const auto& [patch, name] : names) {
        out.line(std::to_string(dimension) + " " + std::to_string(patch) + " \"" + name + "\"");
    }
    out.line("$EndPhysicalNames");
}

/// Names, with what the format demands of them.
template <int D>
std::map<int, std::string> quotable_names(const Mesh<D>& mesh, std::vector<std::string>& notes) {
    std::map<int, std::string> names = portable_names(mesh.patch_names, notes);
    for (auto& [patch, name] : names) {
        if (name.find('"') != std::string::npos) {
            std::replace(name.begin(), name.end(), '"', '\'');
            notes.push_back("the name of patch " + std::to_string(patch) + " was changed to " +
                            name);
        }
    }
    return names;
}

void note_negative(const std::vector<Group>& groups, std::vector<std::string>& notes) {
    for (const Group& group : groups) {
        if (std::any_of(group.labels.begin(), group.labels.end(), [](int l) { return l < 0; })) {
            notes.emplace_back("negative numbers of patches, regions or curves will be read "
                               "without their sign");
            return;
        }
    }
}

} // namespace

template <int D>
std::vector<std::string> write_2(const std::filesystem::path& path, Form form,
                                 const Mesh<D>& mesh) {
    std::vector<std::string> notes;
    const std::vector<Group> groups = groups_of(mesh);
    note_negative(groups, notes);
    Numbers out(path, form);
    write_header(out, "2.2");
    write_comment(out, groups);
    write_names(out, D - 1, quotable_names(mesh, notes));
    out.line("$Nodes");
    out.line(std::to_string(mesh.points.size()));
    for (const NodeId node : mesh.points.ids()) {
        out.integer(std::int64_t{node.value()} + 1);
        out.point(in_space<D>(mesh.points[node]));
    }
    out.end_data();
    out.line("$EndNodes");
    out.line("$Elements");
    out.line(std::to_string(cells_in(groups)));
    for (const Group& group : groups) {
        if (out.binary()) {
            out.integer(info(group.type).gmsh);
            out.integer(static_cast<std::int64_t>(group.labels.size()));
            out.integer(2);
        }
        for (std::size_t i = 0; i < group.labels.size(); ++i) {
            out.integer(group.first_tag + static_cast<std::int64_t>(i));
            if (!out.binary()) {
                out.integer(info(group.type).gmsh);
                out.integer(2);
            }
            out.integer(group.labels[i]);
            out.integer(group.labels[i]);
            for (std::size_t k = 0; k < group.per_cell(); ++k) {
                out.integer(std::int64_t{group.nodes[i * group.per_cell() + k].value()} + 1,
                            k + 1 == group.per_cell());
            }
        }
    }
    out.end_data();
    out.line("$EndElements");
    out.commit();
    return notes;
}

namespace {

/// One entity per label; its tag is the place of the label in this list, from 1.
std::vector<int> entities_of(const std::vector<Group>& groups, int dimension) {
    for (const Group& group : groups) {
        if (group.dimension() == dimension) {
            return distinct({group.labels.begin(), group.labels.end()});
        }
    }
    return {};
}

struct Box {
    Vec<3> low = Vec<3>::Constant(std::numeric_limits<double>::max());
    Vec<3> high = Vec<3>::Constant(std::numeric_limits<double>::lowest());
};

/// All entities get the box of the whole mesh: programs use it for a first look only.
void write_entities(Numbers& out, const std::vector<Group>& groups, const Box& box) {
    out.line("$Entities");
    for (int d = 0; d <= 3; ++d) {
        out.large_integer(static_cast<std::int64_t>(entities_of(groups, d).size()), d == 3);
    }
    for (int d = 1; d <= 3; ++d) {
        std::int64_t tag = 1;
        for (const int label : entities_of(groups, d)) {
            out.integer(tag++);
            for (int k = 0; k < 6; ++k) {
                out.real(k < 3 ? box.low[k] : box.high[k - 3]);
            }
            out.large_integer(label == 0 ? 0 : 1);
            if (label != 0) {
                out.integer(label);
            }
            out.large_integer(0, true); // entities around it
        }
    }
    out.end_data();
    out.line("$EndEntities");
}

/// All nodes as one block of the entity that has the most of them.
template <int D>
void write_nodes(Numbers& out, const Mesh<D>& mesh, int dimension) {
    const auto n = static_cast<std::int64_t>(mesh.points.size());
    out.line("$Nodes");
    out.large_integer(1);
    out.large_integer(n);
    out.large_integer(1);
    out.large_integer(n, true);
    out.integer(dimension);
    out.integer(1);
    out.integer(0);
    out.large_integer(n, true);
    for (std::int64_t tag = 1; tag <= n; ++tag) {
        out.large_integer(tag, true);
    }
    for (const Vec<D>& x : mesh.points) {
        out.point(in_space<D>(x));
    }
    out.end_data();
    out.line("$EndNodes");
}

void write_block(Numbers& out, const Group& group, int entity,
                 const std::vector<std::size_t>& cells) {
    out.integer(group.dimension());
    out.integer(entity);
    out.integer(info(group.type).gmsh);
    out.large_integer(static_cast<std::int64_t>(cells.size()), true);
    for (const std::size_t i : cells) {
        out.large_integer(group.first_tag + static_cast<std::int64_t>(i));
        for (std::size_t k = 0; k < group.per_cell(); ++k) {
            out.large_integer(std::int64_t{group.nodes[i * group.per_cell() + k].value()} + 1,
                              k + 1 == group.per_cell());
        }
    }
}

void write_elements(Numbers& out, const std::vector<Group>& groups) {
    std::int64_t blocks = 0;
    for (const Group& group : groups) {
        blocks += static_cast<std::int64_t>(entities_of(groups, group.dimension()).size());
    }
    out.line("$Elements");
    out.large_integer(blocks);
    out.large_integer(cells_in(groups));
    out.large_integer(1);
    out.large_integer(cells_in(groups), true);
    for (const Group& group : groups) {
        std::map<int, std::vector<std::size_t>> cells;
        for (std::size_t i = 0; i < group.labels.size(); ++i) {
            cells[group.labels[i]].push_back(i);
        }
        int entity = 1;
        for (const auto& [label, list] : cells) {
            write_block(out, group, entity++, list);
        }
    }
    out.end_data();
    out.line("$EndElements");
}

} // namespace

template <int D>
std::vector<std::string> write_4(const std::filesystem::path& path, Form form,
                                 const Mesh<D>& mesh) {
    std::vector<std::string> notes;
    const std::vector<Group> groups = groups_of(mesh);
    note_negative(groups, notes);
    Box box;
    for (const Vec<D>& x : mesh.points) {
        box.low = box.low.cwiseMin(in_space<D>(x));
        box.high = box.high.cwiseMax(in_space<D>(x));
    }
    Numbers out(path, form);
    write_header(out, "4.1");
    write_comment(out, groups);
    write_names(out, D - 1, quotable_names(mesh, notes));
    write_entities(out, groups, box);
    write_nodes(out, mesh, groups.back().dimension());
    write_elements(out, groups);
    out.commit();
    return notes;
}

template std::vector<std::string> write_2(const std::filesystem::path&, Form, const Mesh<2>&);
template std::vector<std::string> write_2(const std::filesystem::path&, Form, const Mesh<3>&);
template std::vector<std::string> write_4(const std::filesystem::path&, Form, const Mesh<2>&);
template std::vector<std::string> write_4(const std::filesystem::path&, Form, const Mesh<3>&);

} // namespace ameco::gmsh
