// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/dimeco.h"

#include "core/io/binary_file.h"
#include "core/io/founding_layout.h"

#include <optional>

namespace ameco::dimeco {
namespace {

constexpr int mark_bytes = 4;
constexpr int blocks = 5;

struct Form {
    NumberLayout numbers;
    bool records = false; ///< of Fortran, one per block
    int dimension = 3;
};

/// Walks over the numbers of the file, which begins with the counts.
class Numbers {
public:
    Numbers(std::string_view bytes, const Form& form)
        : cursor_(bytes.data(),
                  form.numbers.big_endian != (std::endian::native == std::endian::big),
                  form.numbers.int_bytes, form.numbers.real_bytes),
          records_(form.records) {
        cursor_.skip(records_ ? mark_bytes : 0);
        counts_.nodes = cursor_.integer();
        counts_.elements = cursor_.integer();
        counts_.faces = cursor_.integer();
    }
    [[nodiscard]] const founding::Counts& counts() const { return counts_; }
    std::int64_t integer(const char*, std::int64_t) { return cursor_.integer(); }
    double real(const char*, std::int64_t) { return cursor_.real(); }
    /// The marks at the end of the last block and at the beginning of this one.
    void begin_block() { cursor_.skip(records_ ? 2 * mark_bytes : 0); }

private:
    NumberCursor cursor_;
    bool records_;
    founding::Counts counts_;
};

std::int64_t header_bytes(const Form& form) {
    return 3 * form.numbers.int_bytes + (form.records ? mark_bytes : 0);
}

/// The size of the file if its counts make sense in this form.
std::optional<std::int64_t> expected_size(std::string_view bytes, const Form& form) {
    if (static_cast<std::int64_t>(bytes.size()) < header_bytes(form)) {
        return std::nullopt;
    }
    const founding::Counts counts = Numbers(bytes, form).counts();
    if (!counts.possible()) {
        return std::nullopt;
    }
    return 3 * form.numbers.int_bytes + counts.reals(form.dimension) * form.numbers.real_bytes +
           counts.integers(form.dimension) * form.numbers.int_bytes +
           (form.records ? 2 * blocks * mark_bytes : 0);
}

std::optional<Form> detect_form(std::string_view bytes) {
    for (const int dimension : {3, 2}) {
        for (const int real_bytes : {8, 4}) {
            for (const bool records : {false, true}) {
                for (const bool big_endian : {false, true}) {
                    const Form form{{big_endian, 4, real_bytes}, records, dimension};
                    if (expected_size(bytes, form) == static_cast<std::int64_t>(bytes.size())) {
                        return form;
                    }
                }
            }
        }
    }
    return std::nullopt;
}

template <int D>
MeshFile read_in(const Form& form, const Source& source) {
    Numbers numbers(source.bytes, form);
    founding::Reader<D, Numbers> reader(numbers, numbers.counts(), source.name);
    MeshFile file;
    file.format = std::string("AMeCo binary") +
                  (form.numbers.big_endian ? ", big-endian" : ", little-endian") +
                  (form.numbers.real_bytes == 4 ? ", 32-bit coordinates" : "") +
                  (form.records ? ", Fortran records" : "");
    finish_mesh(reader.read(founding::Patches::behind_all_faces),
                {source.name, 1, source.options.surfaces}, file);
    return file;
}

} // namespace

MeshFile read(const Source& source) {
    const std::optional<Form> form = detect_form(source.bytes);
    if (!form) {
        throw InputError(source.name + ": its " + std::to_string(source.bytes.size()) +
                         " bytes do not agree with the counts at its beginning in any byte order; "
                         "it is truncated, damaged, or not an AMeCo mesh");
    }
    return form->dimension == 3 ? read_in<3>(*form, source) : read_in<2>(*form, source);
}

template <int D>
std::vector<std::string> write(const std::filesystem::path& path, const Mesh<D>& mesh,
                               const WriteOptions&) {
    BinaryFile file(path, {});
    const founding::Counts counts = founding::counts_of(mesh);
    file.integer(counts.nodes);
    file.integer(counts.elements);
    file.integer(counts.faces);
    for (const Vec<D>& x : mesh.points) {
        for (int k = 0; k < D; ++k) {
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
    write_cells(mesh.elements);
    write_cells(mesh.faces);
    for (const int patch : mesh.patch) {
        file.integer(patch);
    }
    file.commit();
    return {};
}

template std::vector<std::string> write(const std::filesystem::path&, const Mesh<2>&,
                                        const WriteOptions&);
template std::vector<std::string> write(const std::filesystem::path&, const Mesh<3>&,
                                        const WriteOptions&);

} // namespace ameco::dimeco
