// SPDX-License-Identifier: AGPL-3.0-or-later
#include "app/cli/suggest.h"

#include <algorithm>
#include <cstddef>

namespace ameco::cli {

int edit_distance(std::string_view a, std::string_view b) {
    // Optimal string alignment: d[i][j] is the distance of the first i letters from the first j.
    std::vector<std::vector<int>> d(a.size() + 1, std::vector<int>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                d[i][j] = static_cast<int>(i + j);
                continue;
            }
            const int replaced = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
            }
        }
    }
    return d[a.size()][b.size()];
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
    const std::string* best = nullptr;
    int best_distance = 0;
    for (const std::string& candidate : known) {
        const int distance = candidate.starts_with(word) && word.size() > 2
                                 ? 1 // the beginning of a long name is as good as a slip
                                 : edit_distance(word, candidate);
        if (best == nullptr || distance < best_distance) {
            best = &candidate;
            best_distance = distance;
        }
    }
    const int near = (static_cast<int>(word.size()) + 1) / 3;
    return best != nullptr && best_distance <= near ? ", did you mean " + *best + "?" : "";
}

} // namespace ameco::cli
