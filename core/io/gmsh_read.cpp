// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/gmsh.h"

#include "core/io/byte_order.h"
#include "core/io/gmsh_comment.h"
#include "core/io/gmsh_elements.h"
#include "core/io/mixed_mesh.h"
#include "core/io/text_scanner.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <optional>

namespace ameco::gmsh {
namespace {

/// What is kept of each cell beside its nodes, until the whole file is known.
struct Tags {
    std::vector<std::int64_t> tag;
    std::vector<int> elementary;
};

/// Two labels, of which one is chosen at the end.
struct Labels {
    int physical = 0;
    int elementary = 0;
};

class Reader {
public:
    explicit Reader(const Source& source)
        : text_(source.bytes, source.name, '\0'), source_(source) {}

    MeshFile read() {
        while (text_.skip_blank()) {
            const std::string_view word = text_.token();
            if (word.front() != '$') {
                text_.fail_here("expected a section, found " + in_quotes(word));
            }
            text_.take_line();
            read_section(std::string(word.substr(1)));
        }
        if (version_ == 0) {
            throw InputError(source_.name + ": has no $MeshFormat section; save it as MSH 2.2 or "
                                            "4.1");
        }
        for_each_kind(mixed_, [&](CellType type, auto& cells) { finish_cells(type, cells); });
        mixed_.line_names = names_[1];
        mixed_.face_names = names_[2];
        mixed_.cell_names = names_[3];
        MeshFile file;
        file.format = std::string("Gmsh ") + (version_ == 2 ? "2.2" : "4.1") +
                      (binary_ ? " binary" : " text");
        if (curved_ > 0) {
            file.changes.push_back(std::to_string(curved_) +
                                   " elements of second order were taken as straight ones; their "
                                   "middle nodes are left unused");
        }
        finish_mesh(std::move(mixed_), {source_.name, 1, source_.options.surfaces}, file);
        return file;
    }

private:
    // --- numbers -------------------------------------------------------------------------------

    [[nodiscard]] std::string where() const {
        return "$" + section_ + (row_ < 0 ? "" : ", row " + std::to_string(row_ + 1)) + ": ";
    }
    std::int64_t text_integer() {
        return text_.integer([&] { return where(); });
    }
    /// A 32-bit integer of a binary file.
    std::int64_t integer() {
        return binary_
                   ? load_integer<std::int32_t>(text_.take_bytes(4, "an integer").data(), swapped_)
                   : text_integer();
    }
    /// A 64-bit count or tag of a binary file.
    std::int64_t large_integer() {
        return binary_
                   ? load_integer<std::int64_t>(text_.take_bytes(8, "a number").data(), swapped_)
                   : text_integer();
    }
    double real() {
        return binary_ ? load_real<double>(text_.take_bytes(8, "a coordinate").data(), swapped_)
                       : text_.real([&] { return where(); });
    }
    int label(std::int64_t value) const {
        constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
        if (value < -most || value > most) {
            text_.fail_here(where() + "the tag " + std::to_string(value) +
                            " does not fit into 32 bits");
        }
        return static_cast<int>(value < 0 ? -value
                                          : value); // negative: the entity is turned in its group
    }
    /// \param least_bytes  of a row in a binary file
    void check_room(std::int64_t rows, std::int64_t numbers, std::int64_t least_bytes) const {
        const bool fits =
            binary_ ? rows >= 0 && rows <= text_.left() / std::max<std::int64_t>(1, least_bytes)
                    : text_.has_room(rows, numbers);
        if (!fits || rows > std::numeric_limits<std::int32_t>::max()) {
            text_.fail_room("$" + section_, rows);
        }
    }

    // --- sections ------------------------------------------------------------------------------

    void read_section(std::string name) {
        section_ = std::move(name);
        row_ = -1;
        if (section_ == "MeshFormat") {
            read_format();
        } else if (section_ == "PhysicalNames") {
            read_names();
        } else if (section_ == "Entities" && version_ == 4) {
            read_entities();
        } else if (section_ == "Nodes") {
            require_format();
            version_ == 2 ? read_nodes_2() : read_nodes_4();
            sort_nodes();
        } else if (section_ == "Elements") {
            require_format();
            version_ == 2 ? read_elements_2() : read_elements_4();
        } else {
            skip_section();
            return;
        }
        text_.skip_blank();
        if (text_.token() != "$End" + section_) {
            text_.fail_here("expected $End" + section_ + ", found " + in_quotes(text_.token()));
        }
        text_.take_line();
    }

    void skip_section() {
        const std::string_view rest(text_.here(), static_cast<std::size_t>(text_.left()));
        const std::string end = "$End" + section_;
        const std::size_t at = rest.find(end);
        if (at == std::string_view::npos) {
            text_.fail_here("the section $" + section_ + " has no end; the file is truncated");
        }
        if (section_ == "Comments") {
            labels_are_0_ = rest.substr(0, at).find(zero_labels_comment) != std::string_view::npos;
        }
        text_.take(at + end.size());
        text_.take_line();
    }

    void require_format() const {
        if (version_ == 0) {
            text_.fail_here("$" + section_ +
                            " stands before $MeshFormat; it is damaged, or of MSH "
                            "version 1: save it as MSH 2.2 or 4.1");
        }
    }

    void read_format() {
        text_.skip_blank();
        const std::string version(text_.token());
        text_.take(version.size());
        if (version != "4.1" && version.substr(0, 1) != "2") {
            text_.fail_here("the version is " + in_quotes(version) +
                            "; only MSH 2 and 4.1 can be read: save it as one of them");
        }
        const bool binary = text_integer() == 1;
        if (text_integer() != 8) {
            text_.fail_here("sizes of numbers other than 8 bytes cannot be read");
        }
        version_ = version == "4.1" ? 4 : 2;
        text_.take_line();
        if (binary) {
            take_line_end();
            const auto one = load<std::int32_t>(text_.take_bytes(4, "the byte order").data());
            swapped_ = one != 1;
            if (swapped_ && byte_swap(one) != 1) {
                text_.fail_here("the mark of the byte order is damaged");
            }
            binary_ = true;
        }
    }

    /// Binary data begins right behind the end of the line.
    void take_line_end() {
        if (!text_.at_end()) {
            text_.take(1);
        }
    }
    void begin_binary() {
        if (binary_) {
            take_line_end();
        }
    }

    void read_names() {
        const std::int64_t count = text_integer();
        for (row_ = 0; row_ < count; ++row_) {
            const std::int64_t dimension = text_integer();
            const int tag = label(text_integer());
            std::string_view name = text_.take_line();
            if (name.size() >= 2 && name.front() == '"' && name.back() == '"') {
                name = name.substr(1, name.size() - 2);
            }
            if (dimension >= 0 && dimension <= 3 && !name.empty()) {
                names_[static_cast<std::size_t>(dimension)][tag] = name;
            }
        }
    }

    void read_entities() {
        begin_binary();
        std::array<std::int64_t, 4> counts;
        for (std::int64_t& count : counts) {
            count = large_integer();
            check_room(count, 5, 36);
        }
        for (std::size_t d = 0; d < 4; ++d) {
            for (row_ = 0; row_ < counts[d]; ++row_) {
                const auto tag = integer();
                for (int k = 0; k < (d == 0 ? 3 : 6); ++k) {
                    static_cast<void>(real());
                }
                const std::int64_t physical = large_integer();
                for (std::int64_t k = 0; k < physical; ++k) {
                    const int value = label(integer());
                    if (k == 0) {
                        physical_[{static_cast<std::int64_t>(d), tag}] = value;
                    }
                }
                const std::int64_t bounds = d == 0 ? 0 : large_integer();
                for (std::int64_t k = 0; k < bounds; ++k) {
                    static_cast<void>(integer());
                }
            }
        }
        row_ = -1;
    }

    // --- nodes ---------------------------------------------------------------------------------

    void read_nodes_2() {
        const std::int64_t count = text_integer();
        check_room(count, 4, 28);
        text_.take_line();
        begin_binary();
        mixed_.points.reserve(static_cast<std::size_t>(count));
        tags_.reserve(static_cast<std::size_t>(count));
        for (row_ = 0; row_ < count; ++row_) {
            tags_.push_back(integer());
            read_point();
        }
        row_ = -1;
    }

    void read_point() {
        Vec<3> x;
        for (int k = 0; k < 3; ++k) {
            x[k] = real();
        }
        mixed_.points.push_back(x);
    }

    void read_nodes_4() {
        begin_binary();
        const std::int64_t blocks = large_integer();
        const std::int64_t total = large_integer();
        static_cast<void>(large_integer());
        static_cast<void>(large_integer());
        check_room(total, 4, 32);
        mixed_.points.reserve(static_cast<std::size_t>(total));
        tags_.reserve(static_cast<std::size_t>(total));
        for (row_ = 0; row_ < blocks; ++row_) {
            const std::int64_t dimension = integer();
            static_cast<void>(integer());
            const bool parametric = integer() != 0;
            const std::int64_t count = large_integer();
            check_room(count, 4, 32);
            for (std::int64_t i = 0; i < count; ++i) {
                tags_.push_back(large_integer());
            }
            for (std::int64_t i = 0; i < count; ++i) {
                read_point();
                for (std::int64_t k = 0; k < (parametric ? dimension : 0); ++k) {
                    static_cast<void>(real());
                }
            }
        }
        row_ = -1;
    }

    /// Puts the nodes into the order of their tags.
    void sort_nodes() {
        if (!std::is_sorted(tags_.begin(), tags_.end())) {
            std::vector<std::int32_t> order(tags_.size());
            std::iota(order.begin(), order.end(), 0);
            std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
                return tags_[static_cast<std::size_t>(a)] < tags_[static_cast<std::size_t>(b)];
            });
            IdVector<NodeId, Vec<3>> points(tags_.size(), Vec<3>::Zero());
            std::vector<std::int64_t> tags(tags_.size());
            for (std::size_t i = 0; i < order.size(); ++i) {
                points[NodeId(i)] = mixed_.points[NodeId(order[i])];
                tags[i] = tags_[static_cast<std::size_t>(order[i])];
            }
            mixed_.points = std::move(points);
            tags_ = std::move(tags);
        }
        contiguous_ = !tags_.empty() && tags_.front() > 0 &&
                      tags_.back() - tags_.front() == static_cast<std::int64_t>(tags_.size()) - 1;
        if (const auto twice = std::adjacent_find(tags_.begin(), tags_.end());
            twice != tags_.end()) {
            text_.fail_here("the node " + std::to_string(*twice) + " occurs twice");
        }
    }

    NodeId node_of(std::int64_t tag) const {
        if (!tags_.empty() && tag >= tags_.front() && tag <= tags_.back()) {
            if (contiguous_) {
                return NodeId(static_cast<std::size_t>(tag - tags_.front()));
            }
            const auto at = std::lower_bound(tags_.begin(), tags_.end(), tag);
            if (*at == tag) {
                return NodeId(static_cast<std::size_t>(at - tags_.begin()));
            }
        }
        text_.fail_here(where() + "there is no node " + std::to_string(tag) +
                        (tags_.empty() ? " before the section $Nodes" : ""));
    }

    // --- elements ------------------------------------------------------------------------------

    ElementKind kind_of(std::int64_t code) const {
        const std::optional<ElementKind> kind = element_kind(code);
        if (!kind) {
            text_.fail_here(where() + "elements of the type " + std::to_string(code) +
                            " cannot be read; save the mesh with elements of first order");
        }
        return *kind;
    }

    template <class Next>
    void read_element(const ElementKind& kind, std::int64_t tag, const Labels& labels,
                      Next&& next) {
        std::array<NodeId, 8> nodes;
        const int corners = kind.type ? info(*kind.type).nodes : 0;
        for (int k = 0; k < kind.nodes; ++k) {
            const std::int64_t node = next();
            if (k < corners) {
                nodes[static_cast<std::size_t>(k)] = node_of(node);
            }
        }
        if (!kind.type) {
            return;
        }
        add_cell(mixed_, *kind.type, {nodes.data(), static_cast<std::size_t>(corners)},
                 labels.physical);
        Tags& tags = cell_tags_[static_cast<std::size_t>(*kind.type)];
        tags.tag.push_back(tag);
        tags.elementary.push_back(labels.elementary);
        curved_ += kind.curved ? 1 : 0;
    }

    /// \param count  of tags
    Labels read_labels(std::int64_t count) {
        Labels labels;
        for (std::int64_t k = 0; k < count; ++k) {
            const std::int64_t tag = integer();
            if (k == 0) {
                labels.physical = label(tag);
            } else if (k == 1) {
                labels.elementary = label(tag);
            }
        }
        return labels;
    }

    void read_elements_2() {
        const std::int64_t count = text_integer();
        check_room(count, 4, 8);
        text_.take_line();
        begin_binary();
        row_ = 0;
        while (row_ < count) {
            std::int64_t tag = binary_ ? 0 : integer();
            const ElementKind kind = kind_of(integer());
            const std::int64_t elements = binary_ ? integer() : 1;
            const std::int64_t tags = integer();
            if (elements < 1 || elements > count - row_) {
                text_.fail_here(where() + "a block of " + std::to_string(elements) +
                                " elements goes beyond the " + std::to_string(count) +
                                " of the section");
            }
            for (std::int64_t i = 0; i < elements; ++i, ++row_) {
                tag = binary_ ? integer() : tag;
                const Labels labels = read_labels(tags);
                read_element(kind, tag, labels, [&] { return integer(); });
            }
        }
        row_ = -1;
    }

    void read_elements_4() {
        begin_binary();
        const std::int64_t blocks = large_integer();
        for (int k = 0; k < 3; ++k) {
            static_cast<void>(large_integer());
        }
        for (row_ = 0; row_ < blocks; ++row_) {
            const std::int64_t dimension = integer();
            const std::int64_t entity = integer();
            const ElementKind kind = kind_of(integer());
            const std::int64_t count = large_integer();
            check_room(count, kind.nodes + 1, 8 * (kind.nodes + 1));
            const auto physical = physical_.find({dimension, entity});
            const Labels labels{physical == physical_.end() ? 0 : physical->second, label(entity)};
            for (std::int64_t i = 0; i < count; ++i) {
                const std::int64_t tag = large_integer();
                read_element(kind, tag, labels, [&] { return large_integer(); });
            }
        }
        row_ = -1;
    }

    // --- at the end ----------------------------------------------------------------------------

    /// Whether some cell of this dimension has a physical tag.
    bool has_physical(int dimension) {
        bool found = false;
        for_each_kind(mixed_, [&](CellType type, const auto& cells) {
            found = found || (info(type).dimension == dimension &&
                              std::any_of(cells.labels.begin(), cells.labels.end(),
                                          [](int label) { return label != 0; }));
        });
        return found;
    }

    /// Chooses the labels of one kind of cells, and puts the cells into the order of their tags.
    template <std::size_t N>
    void finish_cells(CellType type, Cells<N>& cells) {
        const auto dimension = static_cast<std::size_t>(info(type).dimension);
        if (!uses_physical_[dimension]) {
            uses_physical_[dimension] = has_physical(static_cast<int>(dimension)) || labels_are_0_;
        }
        Tags& tags = cell_tags_[static_cast<std::size_t>(type)];
        if (!*uses_physical_[dimension]) {
            cells.labels = tags.elementary;
        }
        if (std::is_sorted(tags.tag.begin(), tags.tag.end())) {
            return;
        }
        std::vector<std::int32_t> order(tags.tag.size());
        std::iota(order.begin(), order.end(), 0);
        std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
            return tags.tag[static_cast<std::size_t>(a)] < tags.tag[static_cast<std::size_t>(b)];
        });
        Cells<N> sorted_cells;
        for (const std::int32_t i : order) {
            const auto at = static_cast<std::size_t>(i);
            sorted_cells.add(cells.nodes[at], cells.labels[at]);
        }
        cells = std::move(sorted_cells);
    }

    TextScanner text_;
    const Source& source_;
    int version_ = 0; ///< 2 or 4; 0 before $MeshFormat
    bool binary_ = false;
    bool swapped_ = false;
    std::string section_;
    std::int64_t row_ = -1; ///< in the section, for messages
    MixedMesh<3> mixed_;
    std::vector<std::int64_t> tags_; ///< of the nodes, ascending
    bool contiguous_ = false;        ///< whether the tags have no gaps
    std::array<Tags, cell_type_count> cell_tags_;
    std::array<std::map<int, std::string>, 4> names_;               ///< by dimension
    std::map<std::pair<std::int64_t, std::int64_t>, int> physical_; ///< of (dimension, entity)
    std::array<std::optional<bool>, 4> uses_physical_;              ///< by dimension
    bool labels_are_0_ = false;
    std::int64_t curved_ = 0;
};

} // namespace

bool recognises(std::string_view bytes) {
    const std::string_view text = without_blanks_around(bytes.substr(0, 4096));
    return text.substr(0, 11) == "$MeshFormat" || text.substr(0, 9) == "$Comments" ||
           text.substr(0, 4) == "$NOD";
}

MeshFile read(const Source& source) {
    return Reader(source).read();
}

} // namespace ameco::gmsh
