// SPDX-License-Identifier: AGPL-3.0-or-later
// Whatever the way a mesh takes through the formats, it arrives as it left: but for what the table
// of formats says is not kept.
#include "core/io/format.h"
#include "core/mesh/check.h"
#include "tests/core/io/io_support.h"
#include "tests/support/shapes.h"

#include <algorithm>
#include <numeric>

using namespace ameco;
using namespace ameco::test;
using namespace ameco::shapes;

class FormatChainTest : public QObject {
    Q_OBJECT
private slots:
    void keeps_what_the_table_says_data();
    void keeps_what_the_table_says();
    void keeps_it_over_any_chain_data();
    void keeps_it_over_any_chain();
    void keeps_tensors_over_any_chain_data();
    void keeps_tensors_over_any_chain();
    void says_what_is_left_out_in_one_line();
};

namespace {

/// Coordinates that 32-bit reals hold, since some forms of UGRID are of single precision.
template <int D>
Mesh<D> rich_mesh() {
    Mesh<D> mesh;
    if constexpr (D == 3) {
        mesh = cube(4);
        for (std::size_t i = 0; i < 3; ++i) {
            mesh.features.edges.push_back(
                {NodeId(static_cast<int>(i)), NodeId(static_cast<int>(i + 1))});
            mesh.features.edge_labels.push_back(i < 2 ? 4 : 9);
        }
        mesh.features.required_faces = {0, 5};
    } else {
        mesh = square(4);
    }
    for (const ElementId e : mesh.elements.ids()) {
        mesh.region[e] = e.value() % 3 == 0 ? 7 : 2;
    }
    mesh.patch_names = {{1, "wall"}, {2, "upper wing, part 2"}, {4, "far field"}};
    mesh.labels.assign(mesh.points.size(), 0);
    mesh.labels[NodeId(3)] = 5;
    mesh.features.corners = {NodeId(0), NodeId(4)};
    mesh.features.ridges = {0, 1};
    mesh.features.required_nodes = {NodeId(2)};
    return mesh;
}

/// The mesh without what is not kept, with its faces in ascending order of patch and nodes.
template <int D>
Mesh<D> kept(Mesh<D> mesh, unsigned keeps) {
    const auto lacks = [&](Keeps what) { return (keeps & what) == 0; };
    Features& f = mesh.features;
    if (lacks(keeps_patches)) {
        mesh.patch.assign(mesh.faces.size(), 0);
    }
    if (lacks(keeps_names)) {
        mesh.patch_names.clear();
    }
    if (lacks(keeps_regions)) {
        mesh.region.assign(mesh.elements.size(), 0);
    }
    if (lacks(keeps_curves)) {
        f.edges.clear();
        f.edge_labels.clear();
    }
    if (lacks(keeps_features)) {
        Features bare;
        bare.edges = f.edges;
        bare.edge_labels = f.edge_labels;
        f = bare;
    }
    if (lacks(keeps_labels)) {
        mesh.labels.clear();
    }
    // Formats that list faces patch by patch change their order.
    std::vector<std::pair<int, Facet<D>>> faces;
    for (const FaceId i : mesh.faces.ids()) {
        faces.emplace_back(mesh.patch[i], mesh.faces[i]);
    }
    std::sort(faces.begin(), faces.end());
    for (const FaceId i : mesh.faces.ids()) {
        std::tie(mesh.patch[i], mesh.faces[i]) = faces[i.index()];
    }
    return mesh;
}

/// Formats for meshes of D dimensions that are both read and written, one entry per suffix.
template <int D>
std::vector<std::pair<const Format*, std::string>> two_way_formats() {
    std::vector<std::pair<const Format*, std::string>> result;
    for (const Format& format : formats()) {
        if (format.is_metric() || !format.reads() || !format.writes() ||
            (format.keeps & (D == 2 ? keeps_2d : keeps_3d)) == 0) {
            continue;
        }
        for (const std::string_view suffix : format.suffixes) {
            result.emplace_back(&format, suffix);
        }
    }
    return result;
}

template <int D>
Mesh<D> through(const Folder& folder, const Mesh<D>& mesh, const Format& format,
                const std::string& suffix) {
    const std::filesystem::path path = folder / ("mesh" + suffix);
    static_cast<void>(write_mesh(path, mesh, {.format = std::string(format.name)}));
    return std::get<Mesh<D>>(read_mesh(path).mesh);
}

template <int D>
void check_one(int index) {
    const auto [format, suffix] = two_way_formats<D>()[static_cast<std::size_t>(index)];
    const Folder folder;
    const Mesh<D> mesh = rich_mesh<D>();
    const Mesh<D> back = through(folder, mesh, *format, suffix);
    QVERIFY(back.points == mesh.points);
    QVERIFY(back.elements == mesh.elements);
    QVERIFY(kept(back, format->keeps) == kept(mesh, format->keeps));
    QVERIFY(check(back).valid());
}

template <int D>
void check_chain(int seed) {
    const auto all = two_way_formats<D>();
    Random random(static_cast<unsigned>(seed));
    const Mesh<D> mesh = rich_mesh<D>();
    Mesh<D> current = mesh;
    unsigned keeps = ~0u;
    const Folder folder;
    std::string way;
    for (int step = 0; step < 8; ++step) {
        const auto& [format, suffix] =
            all[static_cast<std::size_t>(random.below(static_cast<int>(all.size())))];
        way += " " + std::string(format->name);
        keeps &= format->keeps;
        current = through(folder, current, *format, suffix);
        QVERIFY2(kept(current, keeps) == kept(mesh, keeps), way.c_str());
    }
}

template <int D>
void add_rows() {
    int index = 0;
    for (const auto& [format, suffix] : two_way_formats<D>()) {
        QTest::newRow(
            (std::to_string(D) + "-D " + std::string(format->name) + " " + suffix).c_str())
            << D << index++;
    }
}

} // namespace

void FormatChainTest::keeps_what_the_table_says_data() {
    QTest::addColumn<int>("dimension");
    QTest::addColumn<int>("index");
    add_rows<2>();
    add_rows<3>();
}

void FormatChainTest::keeps_what_the_table_says() {
    QFETCH(int, dimension);
    QFETCH(int, index);
    dimension == 2 ? check_one<2>(index) : check_one<3>(index);
}

void FormatChainTest::keeps_it_over_any_chain_data() {
    QTest::addColumn<int>("dimension");
    QTest::addColumn<int>("seed");
    for (int seed = 1; seed <= 20; ++seed) {
        QTest::newRow(("chain " + std::to_string(seed)).c_str()) << 2 + seed % 2 << seed;
    }
}

void FormatChainTest::keeps_it_over_any_chain() {
    QFETCH(int, dimension);
    QFETCH(int, seed);
    dimension == 2 ? check_chain<2>(seed) : check_chain<3>(seed);
}

void FormatChainTest::keeps_tensors_over_any_chain_data() {
    QTest::addColumn<int>("dimension");
    QTest::newRow("2-D") << 2;
    QTest::newRow("3-D") << 3;
}

void FormatChainTest::keeps_tensors_over_any_chain() {
    QFETCH(int, dimension);
    const Folder folder;
    Random random(4);
    const auto test = [&](auto tensors) {
        constexpr int d =
            std::tuple_size_v<std::decay_t<decltype(tensors[NodeId(0)])>> == 3 ? 2 : 3;
        for (auto& tensor : tensors) {
            for (double& component : tensor) {
                component = random.real();
            }
        }
        auto current = tensors;
        for (const char* name : {"a.sol", "a.metrique", "a.solb", "M6__metrique"}) {
            write_tensors<d>(folder / name, current);
            current = std::get<decltype(tensors)>(read_tensors(folder / name).tensors);
            QVERIFY(current == tensors);
        }
    };
    if (dimension == 2) {
        test(IdVector<NodeId, Tensor<2>>(12));
    } else {
        test(IdVector<NodeId, Tensor<3>>(12));
    }
}

void FormatChainTest::says_what_is_left_out_in_one_line() {
    const Folder folder;
    const std::vector<std::string> notes = write_mesh(folder / "a.dimeco", rich_mesh<3>());
    QCOMPARE(notes.size(), 1U);
    QCOMPARE(notes[0], std::string("left out, since AMeCo cannot hold them: names of patches; "
                                   "regions; curves; corners, ridges and what is required; labels "
                                   "of nodes"));
    QVERIFY(write_mesh(folder / "a.meshb", rich_mesh<3>()).empty());
    QVERIFY(contains(message_of<UsageError>([&] {
                         static_cast<void>(write_mesh(folder / "a.ugrid", rich_mesh<2>()));
                     }),
                     "cannot hold a 2-D mesh"));
}

QTEST_APPLESS_MAIN(FormatChainTest)
#include "format_chain_test.moc"
