// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/dassault.h"

#include "core/io/founding_layout.h"
#include "core/io/text_file.h"
#include "core/io/text_scanner.h"

namespace ameco::dassault {
namespace {

class Numbers {
public:
    explicit Numbers(const Source& source) : text_(source.bytes, source.name, '\0') {}
    std::int64_t integer(const char* what, std::int64_t row) {
        return text_.integer([&] { return where(what, row); });
    }
    double real(const char* what, std::int64_t row) {
        return text_.real([&] { return where(what, row); });
    }
    void begin_block() {}
    [[noreturn]] void fail(const std::string& what) const { text_.fail_here(what); }

private:
    static std::string where(const char* what, std::int64_t row) {
        return std::string(what) + " " + std::to_string(row + 1) + ": ";
    }
    TextScanner text_;
};

template <int D>
MeshFile read_in(Numbers& numbers, const founding::Counts& counts, const Source& source) {
    founding::Reader<D, Numbers> reader(numbers, counts, source.name);
    MeshFile file;
    file.format = "Dassault text";
    finish_mesh(reader.read(founding::Patches::behind_each_face),
                {source.name, 1, source.options.surfaces}, file);
    return file;
}

} // namespace

MeshFile read(const Source& source) {
    Numbers numbers(source);
    founding::Counts counts;
    counts.nodes = numbers.integer("count", 0);
    counts.elements = numbers.integer("count", 1);
    counts.faces = numbers.integer("count", 2);
    const std::int64_t given = count_tokens(source.bytes) - 3;
    const auto needed = [&](int d) { return counts.reals(d) + counts.integers(d); };
    if (counts.possible() && given == needed(3)) {
        return read_in<3>(numbers, counts, source);
    }
    if (counts.possible() && given == needed(2)) {
        return read_in<2>(numbers, counts, source);
    }
    numbers.fail("the counts in the first line ask for " +
                 (counts.possible() ? std::to_string(needed(3)) + " numbers in 3-D or " +
                                          std::to_string(needed(2)) + " in 2-D"
                                    : std::string("an impossible mesh")) +
                 ", but " + std::to_string(given) +
                 " follow; the file is truncated, damaged, or not in Dassault's format");
}

template <int D>
std::vector<std::string> write(const std::filesystem::path& path, const Mesh<D>& mesh,
                               const WriteOptions&) {
    TextFile file(path);
    file.number(mesh.points.size(), ' ');
    file.number(mesh.elements.size(), ' ');
    file.number(mesh.faces.size(), '\n');
    for (const Vec<D>& x : mesh.points) {
        file.point<D>(x);
    }
    for (const Simplex<D>& s : mesh.elements) {
        for (int k = 0; k <= D; ++k) {
            file.number(std::int64_t{s[k].value()} + 1, k < D ? ' ' : '\n');
        }
    }
    for (const FaceId f : mesh.faces.ids()) {
        for (const NodeId node : mesh.faces[f]) {
            file.number(std::int64_t{node.value()} + 1, ' ');
        }
        file.number(mesh.patch[f], '\n');
    }
    file.commit();
    return {};
}

template std::vector<std::string> write(const std::filesystem::path&, const Mesh<2>&,
                                        const WriteOptions&);
template std::vector<std::string> write(const std::filesystem::path&, const Mesh<3>&,
                                        const WriteOptions&);

} // namespace ameco::dassault
