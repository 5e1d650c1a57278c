// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/gmf_binary_reader.h"

#include "core/base/parallel.h"
#include "core/io/byte_order.h"

#include <algorithm>
#include <atomic>

namespace ameco::gmf {
namespace {

constexpr std::int32_t swapped_one = 16777216;
constexpr std::size_t grain = std::size_t{1} << 16;
/// libMeshb knows about 220 keywords, each of which may occur once.
constexpr std::size_t max_records = 4096;
/// Widths of the text in ReferenceStrings: libMeshb writes 64 bytes and reads 256.
constexpr std::int64_t min_string = 64;
constexpr std::int64_t max_string = 1024;
/// Fields of one solution, libMeshb's limit.
constexpr std::int64_t max_fields = 1000;

/// Loads the numbers of one version and byte order.
template <class Int, class Real, bool Swapped>
struct Loader {
    static constexpr std::size_t int_bytes = sizeof(Int);
    static constexpr std::size_t real_bytes = sizeof(Real);
    static std::int64_t integer(const char* at) {
        const Int value = load<Int>(at);
        return Swapped ? byte_swap(value) : value;
    }
    static double real(const char* at) { return load_real<Real>(at, Swapped); }
};

/// Calls `f` with the loader of the file, so that loops are compiled once for each.
template <class F>
void with_loader(int version, bool swapped, F&& f) {
    const auto with_order = [&](auto order) {
        constexpr bool s = decltype(order)::value;
        if (version == 1) {
            f(Loader<std::int32_t, float, s>{});
        } else if (version == 4) {
            f(Loader<std::int64_t, double, s>{});
        } else {
            f(Loader<std::int32_t, double, s>{});
        }
    };
    if (swapped) {
        with_order(std::true_type{});
    } else {
        with_order(std::false_type{});
    }
}

bool fits_int32(std::int64_t value) {
    return value == static_cast<std::int32_t>(value);
}

/// The lowest of the rows that several threads complain about.
class FirstRow {
public:
    void note(std::size_t row) {
        std::size_t seen = row_.load(std::memory_order_relaxed);
        while (row < seen && !row_.compare_exchange_weak(seen, row)) {
        }
    }
    [[nodiscard]] bool found() const { return row_.load() != none; }
    [[nodiscard]] std::size_t row() const { return row_.load(); }

private:
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
    std::atomic<std::size_t> row_{none};
};

} // namespace

bool is_binary(std::string_view bytes) {
    if (bytes.size() < 8) {
        return false;
    }
    const auto mark = load<std::int32_t>(bytes.data());
    return mark == 1 || mark == swapped_one;
}

BinaryReader::BinaryReader(std::string_view bytes, const std::string& name)
    : Reader(name), bytes_(bytes), swapped_(load<std::int32_t>(bytes.data()) == swapped_one) {
    const std::int64_t version = load_integer(4, 4);
    if (version < 1 || version > 4) {
        fail("starts like a Medit binary file of version " + std::to_string(version) +
             ", but only versions 1 to 4 are known; it is damaged or not a Medit file");
    }
    version_ = static_cast<int>(version);
    find_records();
    find_dimension();
    std::stable_sort(records_.begin(), records_.end(), [](const Record& a, const Record& b) {
        return a.keyword == vertices && b.keyword != vertices;
    });
}

std::int64_t BinaryReader::load_integer(std::int64_t at, int bytes) const {
    const char* p = bytes_.data() + at;
    if (bytes == 8) {
        const auto value = load<std::int64_t>(p);
        return swapped_ ? byte_swap(value) : value;
    }
    const auto value = load<std::int32_t>(p);
    return swapped_ ? byte_swap(value) : value;
}

std::string BinaryReader::describe(const Record& record) const {
    return word(record.keyword) + " at byte " + std::to_string(record.begin);
}

void BinaryReader::find_records() {
    const auto size = static_cast<std::int64_t>(bytes_.size());
    const int position_bytes = version_ >= 3 ? 8 : 4;
    std::int64_t at = 8;
    for (;;) {
        Record record{0, at, at + 4 + position_bytes, 0};
        if (record.payload > size) {
            fail("ends at byte " + std::to_string(size) +
                 " without an End record; it is truncated: copy or write it again");
        }
        record.keyword = static_cast<int>(load_integer(at, 4));
        if (record.keyword == end) {
            return;
        }
        record.end = load_integer(at + 4, position_bytes);
        if (record.end < record.payload) {
            fail(describe(record) + " is followed by a record at byte " +
                 std::to_string(record.end) + ", which lies before its own data; it is damaged");
        }
        if (record.end > size) {
            fail(describe(record) + " ends at byte " + std::to_string(record.end) +
                 ", but the file has " + std::to_string(size) +
                 " bytes; it is truncated or damaged");
        }
        if (records_.size() == max_records) {
            fail("has more than " + std::to_string(max_records) + " records up to byte " +
                 std::to_string(at) + "; it is damaged");
        }
        records_.push_back(record);
        at = record.end;
    }
}

void BinaryReader::find_dimension() {
    const auto found = std::find_if(records_.begin(), records_.end(),
                                    [](const Record& r) { return r.keyword == gmf::dimension; });
    if (found == records_.end()) {
        fail("has no Dimension record; it is damaged or not a Medit file");
    }
    // Always 32 bits, in version 4 too.
    const std::int64_t value =
        found->end - found->payload >= 4 ? load_integer(found->payload, 4) : 0;
    if (value != 2 && value != 3) {
        fail(describe(*found) + " is " + std::to_string(value) + ", but must be 2 or 3");
    }
    dimension_ = static_cast<int>(value);
    records_.erase(found);
}

std::string BinaryReader::format() const {
    return "Medit binary, version " + std::to_string(version_) +
           (swapped_ ? ", foreign byte order" : "");
}

std::string BinaryReader::place(const Section& section) const {
    return "byte " + std::to_string(section.place);
}

/// ReferenceStrings of an unknown layout are carried unread.
bool BinaryReader::is_known(const Record& record) const {
    if (is_table(record.keyword) || record.keyword == sol_at_vertices) {
        return true;
    }
    const std::int64_t room = record.end - record.payload - integer_bytes();
    if (record.keyword != reference_strings || room < 0) {
        return false;
    }
    const std::int64_t count = load_integer(record.payload, integer_bytes());
    if (count < 1 || count > room || room % count != 0) {
        return false;
    }
    const std::int64_t width = room / count - 2 * integer_bytes();
    return width >= min_string && width <= max_string;
}

std::optional<Section> BinaryReader::next() {
    while (next_ < records_.size()) {
        const Record& record = records_[next_++];
        if (is_known(record)) {
            return section_of(record);
        }
    }
    return std::nullopt;
}

Section BinaryReader::section_of(const Record& record) const {
    const std::int64_t rows = record.payload + integer_bytes();
    if (rows > record.end) {
        fail(describe(record) + " has no room for its number of rows; the file is damaged");
    }
    Section section;
    section.keyword = record.keyword;
    section.count = load_integer(record.payload, integer_bytes());
    section.rows = bytes_.data() + rows;
    section.place = record.begin;
    if (section.count < 0 || section.count > unknown_count) {
        fail(describe(record) + " announces " + std::to_string(section.count) +
             " rows; the file is damaged, or larger than the 2147483647 rows we can read");
    }
    const RowLayout row = row_layout(record.keyword, dimension_);
    check_room(section, row.reals * real_bytes() + row.integers * integer_bytes());
    return section;
}

const BinaryReader::Record& BinaryReader::record_of(const Section& section) const {
    return *std::find_if(records_.begin(), records_.end(),
                         [&](const Record& r) { return r.begin == section.place; });
}

void BinaryReader::check_room(const Section& section, std::int64_t row_bytes) const {
    const Record& record = record_of(section);
    const std::int64_t room = record.end - (section.rows - bytes_.data());
    if (section.count * row_bytes > room) {
        fail(describe(record) + " announces " + std::to_string(section.count) + " rows of " +
             std::to_string(row_bytes) + " bytes, but has room for " + std::to_string(room) +
             " bytes; the file is damaged");
    }
}

void BinaryReader::read_points(const Section& section, std::span<double> coordinates,
                               std::vector<int>& labels) {
    const auto d = static_cast<std::size_t>(dimension_);
    const auto n = static_cast<std::size_t>(section.count);
    with_loader(version_, swapped_, [&](auto loader) {
        using L = decltype(loader);
        const std::size_t row_bytes = d * L::real_bytes + L::int_bytes;
        std::atomic<bool> any_label{false};
        FirstRow bad_label;
        parallel_for(n, grain, [&](std::size_t begin, std::size_t end) {
            bool any = false;
            for (std::size_t i = begin; i < end; ++i) {
                const char* row = section.rows + i * row_bytes;
                for (std::size_t k = 0; k < d; ++k) {
                    coordinates[i * d + k] = L::real(row + k * L::real_bytes);
                }
                const std::int64_t label = L::integer(row + d * L::real_bytes);
                any = any || label != 0;
                if (!fits_int32(label)) {
                    bad_label.note(i);
                    return;
                }
            }
            if (any) {
                any_label = true;
            }
            if (!any_label) { // they are needed for a second look
                forget(section.rows + begin * row_bytes, section.rows + end * row_bytes);
            }
        });
        const auto label_of = [&](std::size_t i) {
            return L::integer(section.rows + i * row_bytes + d * L::real_bytes);
        };
        if (bad_label.found()) {
            fail_label(section, static_cast<std::int64_t>(bad_label.row()),
                       label_of(bad_label.row()));
        }
        labels.clear();
        if (any_label) {
            labels.resize(n);
            for (std::size_t i = 0; i < n; ++i) {
                labels[i] = static_cast<int>(label_of(i));
            }
        }
    });
}

void BinaryReader::read_cells(const Section& section, std::int64_t node_count,
                              std::span<NodeId> nodes, std::span<int> labels) {
    const std::size_t n = labels.size();
    const std::size_t per_cell = n == 0 ? 0 : nodes.size() / n;
    with_loader(version_, swapped_, [&](auto loader) {
        using L = decltype(loader);
        const std::size_t row_bytes = (per_cell + 1) * L::int_bytes;
        FirstRow bad;
        parallel_for(n, grain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const char* row = section.rows + i * row_bytes;
                const std::int64_t label = L::integer(row + per_cell * L::int_bytes);
                bool good = fits_int32(label);
                labels[i] = static_cast<int>(label);
                for (std::size_t k = 0; k < per_cell; ++k) {
                    const std::int64_t node = L::integer(row + k * L::int_bytes);
                    const bool exists = node >= 1 && node <= node_count;
                    good = good && exists;
                    nodes[i * per_cell + k] =
                        exists ? NodeId(static_cast<std::int32_t>(node - 1)) : NodeId();
                }
                if (!good) {
                    bad.note(i);
                    return;
                }
            }
            forget(section.rows + begin * row_bytes, section.rows + end * row_bytes);
        });
        if (bad.found()) {
            const char* row = section.rows + bad.row() * row_bytes;
            const auto number = static_cast<std::int64_t>(bad.row());
            for (std::size_t k = 0; k < per_cell; ++k) {
                const std::int64_t node = L::integer(row + k * L::int_bytes);
                if (node < 1 || node > node_count) {
                    fail_node(section, number, node, node_count);
                }
            }
            fail_label(section, number, L::integer(row + per_cell * L::int_bytes));
        }
    });
}

void BinaryReader::read_numbers(const Section& section, std::span<std::int32_t> numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        const std::int64_t at =
            (section.rows - bytes_.data()) + static_cast<std::int64_t>(i) * integer_bytes();
        const std::int64_t number = load_integer(at, integer_bytes());
        if (number < 1 || number > unknown_count) {
            fail_number(section, static_cast<std::int64_t>(i), number);
        }
        numbers[i] = static_cast<std::int32_t>(number - 1);
    }
}

std::vector<ReferenceString> BinaryReader::read_strings(const Section& section) {
    std::vector<ReferenceString> strings;
    if (section.count == 0) {
        return strings;
    }
    const std::int64_t row_bytes =
        (record_of(section).end - (section.rows - bytes_.data())) / section.count;
    const int w = integer_bytes();
    for (std::int64_t i = 0; i < section.count; ++i) {
        const std::int64_t at = (section.rows - bytes_.data()) + i * row_bytes;
        const auto width = static_cast<std::size_t>(row_bytes - 2 * w);
        std::string_view text = bytes_.substr(static_cast<std::size_t>(at + 2 * w), width);
        text = text.substr(0, text.find('\0'));
        // Fortran programs pad with blanks.
        text = text.substr(0, text.find_last_not_of(' ') + 1);
        strings.push_back({load_integer(at, w), load_integer(at + w, w), std::string(text)});
    }
    return strings;
}

std::vector<int> BinaryReader::read_solution_types(Section& section) {
    const Record& record = record_of(section);
    const std::int64_t at = section.rows - bytes_.data();
    const std::int64_t count = at + 4 <= record.end ? load_integer(at, 4) : -1;
    if (count < 0 || count > std::min(max_fields, (record.end - at - 4) / 4)) {
        fail(describe(record) + " announces " + std::to_string(count) +
             " fields; the file is damaged");
    }
    std::vector<int> types;
    std::int64_t row_bytes = 0;
    for (std::int64_t i = 0; i < count; ++i) {
        types.push_back(static_cast<int>(load_integer(at + 4 + 4 * i, 4)));
        row_bytes += real_bytes() * values_of_type(types.back(), dimension_);
    }
    section.rows += 4 + 4 * count;
    check_room(section, row_bytes);
    return types;
}

void BinaryReader::read_reals(const Section& section, std::span<double> values) {
    with_loader(version_, swapped_, [&](auto loader) {
        using L = decltype(loader);
        parallel_for(values.size(), grain, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                values[i] = L::real(section.rows + i * L::real_bytes);
            }
        });
    });
}

/// The layout of these records is not known to us, so foreign byte order cannot be mended.
std::vector<OpaqueRecord> BinaryReader::carried() const {
    std::vector<OpaqueRecord> result;
    for (const Record& record : records_) {
        if (swapped_ || is_known(record) || record.end == record.payload) {
            continue;
        }
        const auto* data = reinterpret_cast<const std::byte*>(bytes_.data());
        result.push_back({record.keyword, version_, {data + record.payload, data + record.end}});
    }
    return result;
}

std::vector<std::string> BinaryReader::notes() const {
    const auto lost = std::count_if(records_.begin(), records_.end(), [&](const Record& record) {
        return swapped_ && !is_known(record);
    });
    if (lost == 0) {
        return {};
    }
    return {"skipped " + std::to_string(lost) +
            " records of unknown layout, since the file is in foreign byte order"};
}

} // namespace ameco::gmf
