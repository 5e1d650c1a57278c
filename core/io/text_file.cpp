// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/io/text_file.h"

#include "core/io/text_scanner.h"

namespace ameco {

void TextFile::patch_comments(char comment, const std::map<int, std::string>& names) {
    for (const auto& [patch, name] : names) {
        text({&comment, 1});
        text(patch_comment);
        number(patch, ' ');
        text(name);
        text("\n");
    }
}

} // namespace ameco
