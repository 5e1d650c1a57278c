// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/cgns.h"

#include "core/io/atomic_file.h"
#include "core/io/cgns_library.h"
#include "core/io/patch_names.h"

#include <algorithm>
#include <limits>
#include <set>

namespace ameco::cgns {
namespace {

/// Tags cut to the length of a name in CGNS, no two alike, without the separator of its paths.
std::map<int, std::string> short_tags(const std::map<int, std::string>& tags) {
    std::map<int, std::string> result;
    std::set<std::string> taken{"Elements"};
    for (const auto& [patch, tag] : tags) {
        std::string name = tag.substr(0, name_length);
        std::replace(name.begin(), name.end(), '/', '_');
        if (!taken.insert(name).second) {
            const std::string end = "_" + std::to_string(patch);
            name = name.substr(0, name_length - end.size()) + end;
            taken.insert(name);
        }
        result[patch] = name;
    }
    return result;
}

template <int D>
class Writer {
public:
    Writer(File& file, const Mesh<D>& mesh) : file_(file), mesh_(mesh) {}

    void write(std::vector<std::string>& notes) {
        int base = 0;
        file_.require(cg_base_write(file_.id(), "Base", D, D, &base), "cannot be written");
        const auto n = static_cast<cgsize_t>(mesh_.points.size());
        const auto m = static_cast<cgsize_t>(mesh_.elements.size());
        const cgsize_t size[3] = {n, m, 0};
        int zone = 0;
        file_.require(cg_zone_write(file_.id(), 1, "Zone", size, Unstructured, &zone),
                      "cannot be written");
        write_points();
        write_section("Elements", D == 3 ? TETRA_4 : TRI_3, mesh_.elements.raw());
        write_patches(notes);
    }

private:
    void write_points() {
        std::vector<double> values(mesh_.points.size());
        constexpr std::array<const char*, 3> names{"CoordinateX", "CoordinateY", "CoordinateZ"};
        for (int k = 0; k < D; ++k) {
            for (const NodeId node : mesh_.points.ids()) {
                values[node.index()] = mesh_.points[node][k];
            }
            int number = 0;
            file_.require(cg_coord_write(file_.id(), 1, 1, RealDouble,
                                         names[static_cast<std::size_t>(k)], values.data(),
                                         &number),
                          "cannot be written");
        }
    }

    template <std::size_t N>
    void write_section(const std::string& name, ElementType_t type,
                       const std::vector<std::array<NodeId, N>>& cells) {
        std::vector<cgsize_t> numbers;
        numbers.reserve(cells.size() * N);
        for (const auto& cell : cells) {
            for (const NodeId node : cell) {
                numbers.push_back(static_cast<cgsize_t>(node.value()) + 1);
            }
        }
        const auto last = next_ + static_cast<cgsize_t>(cells.size()) - 1;
        int section = 0;
        file_.require(cg_section_write(file_.id(), 1, 1, name.c_str(), type, next_, last, 0,
                                       numbers.data(), &section),
                      "cannot be written");
        next_ = last + 1;
    }

    void write_patches(std::vector<std::string>& notes) {
        const std::map<int, std::string> names = portable_names(mesh_.patch_names, notes);
        const std::vector<int> patches = distinct(mesh_.patch.raw());
        std::map<int, std::vector<Facet<D>>> faces;
        for (const FaceId f : mesh_.faces.ids()) {
            faces[mesh_.patch[f]].push_back(mesh_.faces[f]);
        }
        for (const auto& [patch, tag] : short_tags(tags_of(patches, names))) {
            const cgsize_t first = next_;
            write_section(tag, D == 3 ? TRI_3 : BAR_2, faces.at(patch));
            const cgsize_t range[2] = {first, next_ - 1};
            const auto name = names.find(patch);
            write_condition(tag, range,
                            std::to_string(patch) +
                                (name == names.end() ? "" : " " + name->second));
        }
        const bool unused = std::any_of(names.begin(), names.end(), [&](const auto& entry) {
            return !faces.contains(entry.first);
        });
        if (unused) {
            notes.emplace_back("names of patches without faces were left out");
        }
    }

    void write_condition(const std::string& tag, const cgsize_t* range,
                         const std::string& description) {
        int family = 0;
        file_.require(cg_family_write(file_.id(), 1, tag.c_str(), &family), "cannot be written");
        int condition = 0;
        file_.require(cg_boco_write(file_.id(), 1, 1, tag.c_str(), FamilySpecified, PointRange, 2,
                                    range, &condition),
                      "cannot be written");
        file_.require(cg_boco_gridlocation_write(file_.id(), 1, 1, condition,
                                                 D == 3 ? FaceCenter : EdgeCenter),
                      "cannot be written");
        file_.require(cg_goto(file_.id(), 1, "Zone_t", 1, "ZoneBC_t", 1, "BC_t", condition, "end"),
                      "cannot be written");
        file_.require(cg_famname_write(tag.c_str()), "cannot be written");
        file_.require(cg_descriptor_write(patch_descriptor, description.c_str()),
                      "cannot be written");
    }

    File& file_;
    const Mesh<D>& mesh_;
    cgsize_t next_ = 1; ///< number of the next element
};

} // namespace

template <int D>
std::vector<std::string> write(const std::filesystem::path& path, Container container,
                               const Mesh<D>& mesh) {
    constexpr auto most = static_cast<std::size_t>(std::numeric_limits<cgsize_t>::max());
    if (mesh.elements.size() > most / (D + 1)) {
        throw UsageError(path.string() + ": too many elements for this build of libcgns, whose "
                                         "numbers have 32 bits; choose another format");
    }
    AtomicFile target(path);
    std::vector<std::string> notes;
    {
        cg_set_file_type(container == Container::hdf5 ? CG_FILE_HDF5 : CG_FILE_ADF);
        File file(target.temporary(), CG_MODE_WRITE, path.string());
        Writer<D>(file, mesh).write(notes);
        file.close();
    }
    target.commit();
    return notes;
}

template std::vector<std::string> write(const std::filesystem::path&, Container, const Mesh<2>&);
template std::vector<std::string> write(const std::filesystem::path&, Container, const Mesh<3>&);

} // namespace ameco::cgns
