// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/spacing.h"

#include <algorithm>
#include <cmath>

namespace ameco {

std::vector<double> growing_layers(double first, double growth, double largest, std::size_t n) {
    std::vector<double> distance{0};
    double height = first;
    for (std::size_t k = 0; k < n; ++k) {
        distance.push_back(distance.back() + height);
        height = std::max(height, std::min(height * growth, largest));
    }
    return distance;
}

double filling_ratio(double height, double length, std::size_t n) {
    const auto filled = [&](double r) {
        double sum = 0;
        for (std::size_t k = 0; k < n; ++k) {
            sum = (sum + height) * r;
        }
        return sum;
    };
    double low = 0, high = 1;
    while (filled(high) < length) {
        high *= 2;
    }
    for (double middle = (low + high) / 2; middle > low && middle < high;
         middle = (low + high) / 2) {
        (filled(middle) < length ? low : high) = middle;
    }
    return high;
}

std::vector<double> equidistribute(double length, std::size_t n,
                                   const std::function<double(double)>& size) {
    // The integrand varies over lengths of about the size itself: step by a small part of it.
    std::vector<double> s{0}, integral{0};
    while (s.back() < length) {
        const double step = std::min(size(s.back()) / 64, length - s.back());
        const double next = step < length - s.back() ? s.back() + step : length;
        integral.push_back(integral.back() + step / size(s.back() + step / 2));
        s.push_back(next);
    }
    std::vector<double> nodes(n + 1);
    std::size_t k = 1;
    for (std::size_t i = 1; i < n; ++i) {
        const double target = integral.back() * static_cast<double>(i) / static_cast<double>(n);
        while (integral[k] < target) {
            ++k;
        }
        const double part = (target - integral[k - 1]) / (integral[k] - integral[k - 1]);
        nodes[i] = s[k - 1] + part * (s[k] - s[k - 1]);
    }
    nodes[n] = length;
    return nodes;
}

} // namespace ameco
