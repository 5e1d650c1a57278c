// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/surface_files.h"

#include "core/io/byte_order.h"
#include "core/io/mixed_mesh.h"
#include "core/io/trial_run.h"

#include <algorithm>
#include <iostream>
#include <istream>
#include <new>
#include <stdexcept>
#include <streambuf>

#include <OpenMesh/Core/IO/IOManager.hh>
#include <OpenMesh/Core/IO/importer/BaseImporter.hh>

namespace ameco::surface_files {
namespace {

namespace om = OpenMesh;

/// Takes points and faces as they come. (A half-edge mesh would refuse faces where more than two
/// meet; colours and normals mean nothing to us.)
class Importer : public om::IO::BaseImporter {
public:
    MixedMesh<3> mixed;
    std::size_t largest_polygon = 0;

    om::VertexHandle add_vertex(const om::Vec3f& p) override {
        return add_vertex(om::Vec3d(p[0], p[1], p[2]));
    }
    om::VertexHandle add_vertex(const om::Vec3d& p) override {
        mixed.points.push_back(Vec<3>(p[0], p[1], p[2]));
        return om::VertexHandle(static_cast<int>(mixed.points.size()) - 1);
    }
    om::VertexHandle add_vertex() override { return add_vertex(om::Vec3d(0, 0, 0)); }
    void set_point(om::VertexHandle v, const om::Vec3f& p) override {
        if (v.is_valid() && static_cast<std::size_t>(v.idx()) < mixed.points.size()) {
            mixed.points[NodeId(v.idx())] = Vec<3>(p[0], p[1], p[2]);
        }
    }
    om::FaceHandle add_face(const VHandles& vertices) override {
        std::array<NodeId, 4> nodes;
        const std::size_t n = vertices.size();
        for (std::size_t k = 0; k < std::min<std::size_t>(n, 4); ++k) {
            nodes[k] = NodeId(vertices[k].idx());
        }
        largest_polygon = std::max(largest_polygon, n);
        if (n == 3 || n == 4) {
            add_cell(mixed, n == 3 ? CellType::triangle : CellType::quadrilateral,
                     {nodes.data(), n}, 0);
        }
        return om::FaceHandle(static_cast<int>(n_faces()) - 1);
    }
    [[nodiscard]] std::size_t n_vertices() const override { return mixed.points.size(); }
    [[nodiscard]] std::size_t n_faces() const override {
        return mixed.triangles.size() + mixed.quadrilaterals.size();
    }
    [[nodiscard]] std::size_t n_edges() const override { return 0; }

    // What files hold beyond points and faces.
    om::HalfedgeHandle add_edge(om::VertexHandle, om::VertexHandle) override {
        return om::HalfedgeHandle();
    }
    om::FaceHandle add_face(om::HalfedgeHandle) override { return om::FaceHandle(); }
    void add_face_texcoords(om::FaceHandle, om::VertexHandle,
                            const std::vector<om::Vec2f>&) override {}
    void add_face_texcoords(om::FaceHandle, om::VertexHandle,
                            const std::vector<om::Vec3f>&) override {}
    void set_face_texindex(om::FaceHandle, int) override {}
    void set_halfedge(om::VertexHandle, om::HalfedgeHandle) override {}
    void set_normal(om::VertexHandle, const om::Vec3f&) override {}
    void set_normal(om::VertexHandle, const om::Vec3d&) override {}
    void set_color(om::VertexHandle, const om::Vec3uc&) override {}
    void set_color(om::VertexHandle, const om::Vec4uc&) override {}
    void set_color(om::VertexHandle, const om::Vec3f&) override {}
    void set_color(om::VertexHandle, const om::Vec4f&) override {}
    void set_texcoord(om::VertexHandle, const om::Vec2f&) override {}
    void set_status(om::VertexHandle, const om::Attributes::StatusInfo&) override {}
    void set_next(om::HalfedgeHandle, om::HalfedgeHandle) override {}
    void set_face(om::HalfedgeHandle, om::FaceHandle) override {}
    void request_face_texcoords2D() override {}
    void set_texcoord(om::HalfedgeHandle, const om::Vec2f&) override {}
    void set_texcoord(om::VertexHandle, const om::Vec3f&) override {}
    void set_texcoord(om::HalfedgeHandle, const om::Vec3f&) override {}
    void set_status(om::HalfedgeHandle, const om::Attributes::StatusInfo&) override {}
    void set_color(om::EdgeHandle, const om::Vec3uc&) override {}
    void set_color(om::EdgeHandle, const om::Vec4uc&) override {}
    void set_color(om::EdgeHandle, const om::Vec3f&) override {}
    void set_color(om::EdgeHandle, const om::Vec4f&) override {}
    void set_status(om::EdgeHandle, const om::Attributes::StatusInfo&) override {}
    void set_normal(om::FaceHandle, const om::Vec3f&) override {}
    void set_normal(om::FaceHandle, const om::Vec3d&) override {}
    void set_color(om::FaceHandle, const om::Vec3uc&) override {}
    void set_color(om::FaceHandle, const om::Vec4uc&) override {}
    void set_color(om::FaceHandle, const om::Vec3f&) override {}
    void set_color(om::FaceHandle, const om::Vec4f&) override {}
    void set_status(om::FaceHandle, const om::Attributes::StatusInfo&) override {}
    void add_texture_information(int, std::string) override {}
};

/// A stream over bytes in memory, without a copy of them.
class MemoryBuffer : public std::streambuf {
public:
    explicit MemoryBuffer(std::string_view bytes) {
        // The interface predates const; nothing is written.
        char* begin = const_cast<char*>(bytes.data());
        setg(begin, begin, begin + bytes.size());
    }

protected:
    pos_type seekoff(off_type offset, std::ios_base::seekdir from,
                     std::ios_base::openmode) override {
        const off_type base = from == std::ios_base::beg   ? 0
                              : from == std::ios_base::cur ? gptr() - eback()
                                                           : egptr() - eback();
        return seekpos(base + offset, std::ios_base::in);
    }
    pos_type seekpos(pos_type position, std::ios_base::openmode) override {
        if (position < 0 || position > egptr() - eback()) {
            return pos_type(off_type(-1));
        }
        setg(eback(), eback() + static_cast<std::ptrdiff_t>(position), egptr());
        return position;
    }
};

} // namespace

namespace {

/// OpenMesh reports to streams of its own, and here and there to std::cerr.
class Silence {
public:
    Silence() : before_(std::cerr.rdbuf(nullptr)) {
        omerr().disable();
        omlog().disable();
    }
    ~Silence() {
        std::cerr.rdbuf(before_);
        std::cerr.clear(); // writing to nowhere has failed
    }
    Silence(const Silence&) = delete;
    Silence& operator=(const Silence&) = delete;

private:
    std::streambuf* before_;
};

[[noreturn]] void fail(const Source& source, const std::string& suffix) {
    throw InputError(source.name + ": cannot be read as " + suffix +
                     "; it is truncated, damaged, or of another format");
}

/// STL comes in two forms under one name. A text begins with the word solid, but so do some binary
/// files, whose size tells: 84 bytes, the last four a count, and 50 for each triangle.
bool is_binary_stl(const Source& source, const std::string& suffix) {
    constexpr std::size_t head = 84;
    constexpr std::size_t triangle = 50;
    const std::string_view bytes = source.bytes;
    const bool has_head = bytes.size() >= head;
    const std::uint32_t count =
        has_head ? static_cast<std::uint32_t>(load_integer<std::int32_t>(
                       bytes.data() + head - 4, std::endian::native == std::endian::big))
                 : 0;
    const bool fits = has_head && bytes.size() >= head + std::size_t{count} * triangle;
    if (bytes.substr(0, 5) == "solid" && !(fits && count > 0)) {
        return false;
    }
    if (!fits) {
        fail(source, suffix);
    }
    return true;
}

bool read_stream(const Source& source, const std::string& suffix, Importer& importer) {
    om::IO::Options options;
    if (suffix == "stl" && is_binary_stl(source, suffix)) {
        options += om::IO::Options::Binary;
    }
    MemoryBuffer buffer(source.bytes);
    std::istream stream(&buffer);
    if (suffix == "off" || suffix == "ply") {
        // These readers believe the counts in a file, and go on behind its end for as long.
        stream.exceptions(std::ios::failbit | std::ios::badbit);
    }
    try {
        return om::IO::IOManager().read(stream, suffix, importer, options);
    } catch (const std::ios_base::failure&) {
        return false;
    } catch (const std::bad_alloc&) {
        return false;
    } catch (const std::length_error&) {
        return false;
    }
}

} // namespace

MeshFile read(const Source& source, const std::string& suffix) {
    const Silence silence;
    require_survival(source.name, "OpenMesh", {static_cast<std::int64_t>(source.bytes.size())},
                     [&] {
                         Importer trial;
                         if (!read_stream(source, suffix, trial)) {
                             fail(source, suffix);
                         }
                     });
    Importer importer;
    if (!read_stream(source, suffix, importer)) {
        fail(source, suffix);
    }
    if (importer.largest_polygon > 4) {
        throw InputError(source.name + ": holds polygons of up to " +
                         std::to_string(importer.largest_polygon) +
                         " corners; split them into triangles first");
    }
    MeshFile file;
    file.format = suffix;
    std::transform(file.format.begin(), file.format.end(), file.format.begin(),
                   [](char c) { return static_cast<char>(c - 'a' + 'A'); });
    finish_mesh(std::move(importer.mixed), {source.name, 1, source.options.surfaces}, file);
    return file;
}

} // namespace ameco::surface_files
