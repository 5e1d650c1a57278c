// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// The text form of GMF (.mesh, .sol), read from memory in one pass.
///
/// Words and numbers separated by blanks; `#` begins a comment. Unknown sections are skipped.
/// Names of patches stand in comments `# ameco patch 3 wing`, which every other program skips;
/// ReferenceStrings sections are read too.
#pragma once

#include "core/io/gmf_reader.h"
#include "core/io/text_scanner.h"

namespace ameco::gmf {

[[nodiscard]] bool is_text(std::string_view bytes);

class TextReader : public Reader {
public:
    /// Reads the header: MeshVersionFormatted and Dimension.
    TextReader(std::string_view bytes, const std::string& name);

    [[nodiscard]] std::string format() const override;
    [[nodiscard]] std::string place(const Section& section) const override;
    [[nodiscard]] std::optional<Section> next() override;
    void skip(const Section&) override { skip_numbers(); }
    void read_points(const Section& section, std::span<double> coordinates,
                     std::vector<int>& labels) override;
    void read_cells(const Section& section, std::int64_t node_count, std::span<NodeId> nodes,
                    std::span<int> labels) override;
    void read_numbers(const Section& section, std::span<std::int32_t> numbers) override;
    std::vector<ReferenceString> read_strings(const Section& section) override;
    std::vector<int> read_solution_types(Section& section) override;
    void read_reals(const Section& section, std::span<double> values) override;
    [[nodiscard]] std::vector<OpaqueRecord> carried() const override { return {}; }
    [[nodiscard]] std::vector<ReferenceString> names_in_comments() const override;
    [[nodiscard]] std::vector<std::string> notes() const override;

private:
    /// Where a number is read, for messages.
    struct Row {
        const Section& section;
        std::int64_t index; ///< 0-based
        [[nodiscard]] std::string operator()() const;
    };

    void skip_numbers();
    void skip_section(std::string_view word);
    void check_room(const Section& section, std::int64_t numbers_per_row) const;
    [[nodiscard]] int label(const Row& row);
    void read_dimension();

    TextScanner text_;
    bool ended_ = false;               ///< the End keyword was seen
    std::vector<std::string> skipped_; ///< the first few unknown sections
    std::int64_t skipped_count_ = 0;
};

} // namespace ameco::gmf
