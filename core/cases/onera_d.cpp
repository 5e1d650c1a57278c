// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/cases/onera_d.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ameco {
namespace {

constexpr std::array<std::array<double, 2>, 72> published{{
    {0.0000000, 0.0000000}, {0.0000165, 0.0006914}, {0.0000696, 0.0014416}, {0.0001675, 0.0022554},
    {0.0003232, 0.0031382}, {0.0005508, 0.0040959}, {0.0008657, 0.0051343}, {0.0012868, 0.0062598},
    {0.0018364, 0.0074784}, {0.0025441, 0.0087958}, {0.0034428, 0.0102163}, {0.0045704, 0.0117419},
    {0.0059751, 0.0133708}, {0.0077112, 0.0150951}, {0.0098413, 0.0168984}, {0.0124479, 0.0187537},
    {0.0156171, 0.0206220}, {0.0194609, 0.0224545}, {0.0241067, 0.0242004}, {0.0297008, 0.0258245},
    {0.0364261, 0.0273317}, {0.0444852, 0.0287912}, {0.0541248, 0.0303278}, {0.0656303, 0.0320138},
    {0.0793366, 0.0338372}, {0.0956354, 0.0357742}, {0.1149796, 0.0377923}, {0.1378963, 0.0398522},
    {0.1649976, 0.0419089}, {0.1919327, 0.0436214}, {0.2187096, 0.0450507}, {0.2453310, 0.0462358},
    {0.2717978, 0.0471987}, {0.2981113, 0.0479494}, {0.3242726, 0.0484902}, {0.3502830, 0.0488183},
    {0.3761446, 0.0489296}, {0.4018567, 0.0488202}, {0.4274223, 0.0484833}, {0.4528441, 0.0479351},
    {0.4781197, 0.0471661}, {0.5032514, 0.0461903}, {0.5282426, 0.0450209}, {0.5530937, 0.0436741},
    {0.5778043, 0.0421684}, {0.6023757, 0.0405241}, {0.6268104, 0.0387613}, {0.6511093, 0.0368990},
    {0.6752726, 0.0349542}, {0.6993027, 0.0329402}, {0.7231995, 0.0308662}, {0.7469658, 0.0287365},
    {0.7705998, 0.0265505}, {0.7941055, 0.0243027}, {0.8174828, 0.0219842}, {0.8407324, 0.0195838},
    {0.8638564, 0.0170915}, {0.8868235, 0.0145051}, {0.9061905, 0.0122389}, {0.9225336, 0.0102727},
    {0.9363346, 0.0085827}, {0.9479946, 0.0071423}, {0.9578511, 0.0059224}, {0.9661860, 0.0048907},
    {0.9732361, 0.0040180}, {0.9792020, 0.0032796}, {0.9842508, 0.0026547}, {0.9885252, 0.0021257},
    {0.9921438, 0.0016778}, {0.9952080, 0.0012985}, {0.9978030, 0.0009773}, {1.0000000, 0.0007052},
}};

/// Second derivatives of the cubic spline through one coordinate of the points. The section is
/// symmetric, so at the leading edge x is even (no slope) and z odd (no curvature) in the
/// parameter; at the other end there is no curvature.
std::vector<double> second_derivatives(const std::vector<double>& t, const std::vector<double>& f,
                                       bool even) {
    const std::size_t n = t.size();
    std::vector<double> upper(n, 0), m(n, 0); // forward sweep of the tridiagonal system
    if (even) {
        upper[0] = 0.5;
        m[0] = 3 * (f[1] - f[0]) / ((t[1] - t[0]) * (t[1] - t[0]));
    }
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const double left = t[i] - t[i - 1], right = t[i + 1] - t[i];
        const double jump = (f[i + 1] - f[i]) / right - (f[i] - f[i - 1]) / left;
        const double pivot = 2 * (left + right) - left * upper[i - 1];
        upper[i] = right / pivot;
        m[i] = (6 * jump - left * m[i - 1]) / pivot;
    }
    for (std::size_t i = n - 1; i-- > 0;) {
        m[i] -= upper[i] * m[i + 1];
    }
    return m;
}

} // namespace

OneraD::OneraD(TrailingEdge trailing_edge) : trailing_edge_(trailing_edge) {
    std::vector<double> x, z;
    for (const auto& p : published) {
        points_.emplace_back(p[0], p[1]);
        x.push_back(p[0]);
        z.push_back(p[1]);
        const std::size_t i = points_.size() - 1;
        knots_.push_back(i == 0 ? 0 : knots_.back() + (points_[i] - points_[i - 1]).norm());
    }
    const auto x2 = second_derivatives(knots_, x, true);
    const auto z2 = second_derivatives(knots_, z, false);
    for (std::size_t i = 0; i < points_.size(); ++i) {
        second_.emplace_back(x2[i], z2[i]);
    }
    constexpr int per_piece = 32;
    Vec<2> last = points_.front();
    samples_.push_back({0, 0});
    for (std::size_t i = 0; i < knots_.size(); ++i) {
        const double begin = knots_[i];
        const double end = i + 1 < knots_.size() ? knots_[i + 1] : knots_.back() + 1;
        for (int k = 1; k <= per_piece; ++k) {
            const double t = k == per_piece ? end : begin + (end - begin) * k / per_piece;
            const Vec<2> p = at(t);
            samples_.push_back({samples_.back().arc + (p - last).norm(), t});
            last = p;
        }
    }
}

Vec<2> OneraD::operator()(double s) const {
    const auto above = std::lower_bound(samples_.begin() + 1, samples_.end() - 1, s,
                                        [](const Sample& a, double arc) { return a.arc < arc; });
    const Sample& a = *(above - 1);
    const Sample& b = *above;
    const double part = std::clamp((s - a.arc) / (b.arc - a.arc), 0.0, 1.0);
    return at(part < 1 ? a.t + part * (b.t - a.t) : b.t);
}

Vec<2> OneraD::at(double t) const {
    return t <= knots_.back() ? spline(t) : closing(t - knots_.back());
}

Vec<2> OneraD::spline(double t) const {
    const auto above = std::lower_bound(knots_.begin() + 1, knots_.end() - 1, t);
    const auto i = static_cast<std::size_t>(above - knots_.begin()) - 1;
    const double h = knots_[i + 1] - knots_[i];
    const double b = (t - knots_[i]) / h, a = 1 - b;
    return a * points_[i] + b * points_[i + 1] +
           h * h / 6 * ((a * a * a - a) * second_[i] + (b * b * b - b) * second_[i + 1]);
}

Vec<2> OneraD::closing(double part) const {
    const Vec<2> end = points_.back();
    const Vec<2> edge = end - points_[points_.size() - 2];
    const double slope = std::atan2(-edge[1], edge[0]);
    if (trailing_edge_ == TrailingEdge::sharp) {
        return {end[0] + part * end[1] / std::tan(slope), end[1] * (1 - part)};
    }
    const double radius = end[1] / std::cos(slope);
    const double centre = end[0] - radius * std::sin(slope);
    // From the normal of the upper side down to the chord.
    const double angle = (std::numbers::pi / 2 - slope) * (1 - part);
    return {centre + radius * std::cos(angle), radius * std::sin(angle)};
}

} // namespace ameco
