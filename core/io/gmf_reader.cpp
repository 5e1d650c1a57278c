// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/gmf_reader.h"

#include "core/base/error.h"
#include "core/io/gmf_binary_reader.h"
#include "core/io/gmf_text_reader.h"

namespace ameco::gmf {

void Reader::fail(const std::string& what) const {
    throw InputError(name_ + ": " + what);
}

void Reader::fail_node(const Section& section, std::int64_t row, std::int64_t node,
                       std::int64_t node_count) const {
    const std::string text = std::string(entity(section.keyword)) + " " + std::to_string(row + 1) +
                             " uses node " + std::to_string(node);
    if (node < 1) {
        fail(text + ", but nodes are numbered from 1");
    }
    if (node_count == unknown_count) {
        fail(text + ", but a mesh has at most " + std::to_string(unknown_count) + " nodes");
    }
    fail(text + ", but the file has " + std::to_string(node_count) + " nodes");
}

void Reader::fail_label(const Section& section, std::int64_t row, std::int64_t label) const {
    fail(std::string(entity(section.keyword)) + " " + std::to_string(row + 1) + " has the label " +
         std::to_string(label) + "; labels must fit into 32 bits: renumber them");
}

void Reader::fail_number(const Section& section, std::int64_t row, std::int64_t number) const {
    fail(std::string(entity(section.keyword)) + " " + std::to_string(row + 1) + " is number " +
         std::to_string(number) + ", which does not exist: numbers run from 1 to the count");
}

std::unique_ptr<Reader> open_reader(std::string_view bytes, const std::string& name) {
    if (is_binary(bytes)) {
        return std::make_unique<BinaryReader>(bytes, name);
    }
    if (is_text(bytes)) {
        return std::make_unique<TextReader>(bytes, name);
    }
    return nullptr;
}

} // namespace ameco::gmf
