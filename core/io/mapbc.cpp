// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/mapbc.h"

#include "core/io/text_file.h"
#include "core/io/text_scanner.h"

namespace ameco::mapbc {

std::map<int, Patch> read(std::string_view bytes, const std::string& name) {
    TextScanner text(bytes, name, '\0', TextScanner::Rows::lines);
    const auto where = [] { return std::string(); };
    const auto number = [&] {
        const std::int64_t value = text.integer(where);
        if (value != static_cast<std::int32_t>(value)) {
            text.fail_here("a number does not fit into 32 bits");
        }
        return static_cast<int>(value);
    };
    if (!text.next_row()) {
        text.fail_expected("", "the number of patches");
    }
    const std::int64_t count = text.integer(where);
    if (!text.has_room(count, 2)) {
        text.fail_room("the first line", count);
    }
    std::map<int, Patch> patches;
    for (std::int64_t i = 0; i < count; ++i) {
        if (!text.next_row()) {
            text.fail_expected("", "a patch");
        }
        const int id = number();
        Patch patch;
        patch.condition = number();
        patch.name = text.take_line();
        patches[id] = std::move(patch);
    }
    return patches;
}

void write(const std::filesystem::path& path, const std::map<int, Patch>& patches) {
    TextFile file(path);
    file.number(patches.size(), '\n');
    for (const auto& [id, patch] : patches) {
        file.number(id, ' ');
        file.number(patch.condition, ' ');
        file.text(patch.name + "\n");
    }
    file.commit();
}

} // namespace ameco::mapbc
