// SPDX-License-Identifier: AGPL-3.0-or-later
// Thousands of damaged files of every format, the same ones in every run: an Error or a mesh, never
// a crash, never more memory than the size of the file justifies. (Medit has its own test.)
#include "core/io/format.h"
#include "tests/core/io/io_support.h"
#include "tests/fuzz/allocations.h"
#include "tests/fuzz/damage.h"
#include "tests/support/shapes.h"

using namespace ameco;
using namespace ameco::test;

class FormatMutationTest : public QObject {
    Q_OBJECT
private slots:
    void ends_in_an_error_or_a_mesh_data();
    void ends_in_an_error_or_a_mesh();
    void survives_damage_to_each_of_several_files_data();
    void survives_damage_to_each_of_several_files();
    void survives_what_libraries_do_to_damaged_files_data();
    void survives_what_libraries_do_to_damaged_files();
};

namespace {

template <int D>
Mesh<D> seed_mesh() {
    Mesh<D> mesh;
    if constexpr (D == 3) {
        mesh = shapes::cube(1);
    } else {
        mesh = shapes::square(2);
    }
    mesh.patch_names = {{1, "wall"}, {2, "far field"}};
    mesh.region[ElementId(0)] = 4;
    return mesh;
}

/// Formats that are one file, and read by code of our own.
bool is_single(const Format& format) {
    for (const char* other :
         {"medit", "medit-text", "mtc", "tetgen", "cgns", "cgns-adf", "vtu", "vtk", "pvd"}) {
        if (format.name == other) {
            return false;
        }
    }
    return !format.is_metric();
}

template <int D>
void add_rows() {
    for (const Format& format : formats()) {
        if (!is_single(format) || (format.keeps & (D == 2 ? keeps_2d : keeps_3d)) == 0) {
            continue;
        }
        for (const std::string_view suffix : format.suffixes) {
            const Folder folder;
            const auto path = folder / ("seed" + std::string(suffix));
            static_cast<void>(
                write_mesh(path, seed_mesh<D>(), {.format = std::string(format.name)}));
            QTest::newRow(
                (std::to_string(D) + "-D " + std::string(format.name) + " " + std::string(suffix))
                    .c_str())
                << QByteArray::fromStdString(std::string(format.name))
                << QByteArray::fromStdString(std::string(suffix))
                << QByteArray::fromStdString(content_of(path));
        }
    }
}

bool is_text(const std::string& bytes) {
    return bytes.find('\0') == std::string::npos;
}

} // namespace

void FormatMutationTest::ends_in_an_error_or_a_mesh_data() {
    QTest::addColumn<QByteArray>("name");
    QTest::addColumn<QByteArray>("suffix");
    QTest::addColumn<QByteArray>("seed");
    add_rows<2>();
    add_rows<3>();
}

void FormatMutationTest::ends_in_an_error_or_a_mesh() {
    QFETCH(QByteArray, name);
    QFETCH(QByteArray, suffix);
    QFETCH(QByteArray, seed);
    const Format& format = *format_of_name(name.toStdString());
    const std::string whole = seed.toStdString();
    Random random(20);
    int successes = 0;
    int failures = 0;
    for (int i = 0; i < 2000; ++i) {
        const std::string bytes = i == 0 ? whole : damaged(whole, random, is_text(whole));
        const auto size = static_cast<std::int64_t>(bytes.size());
        const Source source{"/nowhere/damaged" + suffix.toStdString(),
                            "damaged",
                            bytes,
                            {.surfaces = true, .from_memory = true},
                            nullptr};
        const std::int64_t before = allocations.live;
        allocations.reset();
        try {
            static_cast<void>(format.read(source));
            ++successes;
        } catch (const Error& error) {
            QVERIFY(std::string(error.what()).find("damaged: ") == 0);
            ++failures;
        }
        // A few hundred bytes for messages and bookkeeping, whatever the size of the file.
        const std::int64_t largest = allocations.largest;
        const std::int64_t peak = allocations.peak - before;
        QVERIFY2(largest <= 4 * size + 1024, qPrintable(QString::number(largest)));
        QVERIFY2(peak <= 16 * size + 16384, qPrintable(QString::number(peak)));
    }
    QVERIFY(successes > 0);
    QVERIFY(failures > 100);
}

void FormatMutationTest::survives_damage_to_each_of_several_files_data() {
    QTest::addColumn<QString>("main_file");
    QTest::addColumn<QString>("damaged_file");
    for (const char* part : {"a.node", "a.ele", "a.face"}) {
        QTest::newRow(part) << QString("a.node") << QString(part);
    }
    for (const char* part : {"b.mtc", "b.t", "b.t.patches"}) {
        QTest::newRow(part) << QString("b.mtc") << QString(part);
    }
    QTest::newRow("c.mapbc") << QString("c.ugrid") << QString("c.mapbc");
}

void FormatMutationTest::survives_damage_to_each_of_several_files() {
    QFETCH(QString, main_file);
    QFETCH(QString, damaged_file);
    const Folder folder;
    const auto path = folder / main_file.toStdString();
    static_cast<void>(write_mesh(path, seed_mesh<3>()));
    const std::string whole = content_of(folder / damaged_file.toStdString());
    QVERIFY(!whole.empty());
    Random random(21);
    for (int i = 0; i < 500; ++i) {
        static_cast<void>(folder.file(damaged_file.toStdString(), damaged(whole, random, true)));
        try {
            static_cast<void>(read_mesh(path, {.surfaces = true}));
        } catch (const Error& error) {
            QVERIFY(std::string(error.what()).find(folder.path().string()) == 0);
        }
    }
}

void FormatMutationTest::survives_what_libraries_do_to_damaged_files_data() {
    QTest::addColumn<QString>("suffix");
    for (const char* name : {"cgns", "vtu", "stl", "obj", "ply", "off"}) {
        if (format_of_name(name)->reads()) {
            QTest::newRow(name) << QString(".") + name;
        }
    }
    if (format_of_name("cgns-adf")->reads()) {
        QTest::newRow("cgns-adf") << QString(".adf.cgns");
    }
    const char* const with_library[] = {"cgns", "vtu", "stl"};
    if (std::none_of(std::begin(with_library), std::end(with_library),
                     [](const char* name) { return format_of_name(name)->reads(); })) {
        QSKIP("this build has neither libcgns nor VTK nor OpenMesh");
    }
}

/// They are read in a trial first, so that a crash is not ours.
void FormatMutationTest::survives_what_libraries_do_to_damaged_files() {
    QFETCH(QString, suffix);
    const Folder folder;
    const auto path = folder / ("a" + suffix.toStdString());
    static_cast<void>(
        write_mesh(path, seed_mesh<3>(), {.format = suffix == ".adf.cgns" ? "cgns-adf" : ""}));
    const std::string whole = content_of(path);
    Random random(22);
    int failures = 0;
    for (int i = 0; i < 150; ++i) {
        const auto bad =
            folder.file("bad" + suffix.toStdString(), damaged(whole, random, is_text(whole)));
        const std::int64_t before = allocations.live;
        allocations.reset();
        try {
            static_cast<void>(read_mesh(bad, {.surfaces = true}));
        } catch (const Error& error) {
            QVERIFY2(std::string(error.what()).find(bad.string() + ": ") == 0, error.what());
            ++failures;
        }
        // What the trial has allowed: 32 MiB for the library and 8 times the file.
        const std::int64_t peak = allocations.peak - before;
        QVERIFY2(peak <= (std::int64_t{32} << 20) + 8 * static_cast<std::int64_t>(whole.size()),
                 qPrintable(QString::number(peak)));
    }
    QVERIFY(failures > 0);
}

QTEST_APPLESS_MAIN(FormatMutationTest)
#include "format_mutation_test.moc"
