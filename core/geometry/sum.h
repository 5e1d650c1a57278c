// SPDX-License-Identifier: AGPL-3.0-or-later
/// \file
/// Sums of many numbers without loss.
#pragma once

#include <cmath>

namespace ameco {

/// A running sum with Neumaier's compensation: the result is as good as if computed with twice the
/// digits and rounded once, so that millions of volumes that differ by 1e9 still add up.
class Sum {
public:
    void add(double x) {
        const double t = sum_ + x;
        rest_ += std::abs(sum_) >= std::abs(x) ? (sum_ - t) + x : (x - t) + sum_;
        sum_ = t;
    }
    void add(const Sum& other) {
        add(other.sum_);
        rest_ += other.rest_;
    }
    [[nodiscard]] double value() const { return sum_ + rest_; }

private:
    double sum_ = 0;
    double rest_ = 0;
};

} // namespace ameco
