// SPDX-License-Identifier: AGPL-3.0-or-later
#include "core/geometry/predicates.h"

#include <QTest>

#include <array>
#include <cmath>
#include <limits>
#include <random>

using namespace ameco;

namespace {

// Determinants of integer coordinates below 2^40 in magnitude fit in 128 bits: six products of
// three differences below 2^41.
__extension__ using Int128 = __int128;
using Int2 = std::array<std::int64_t, 2>;
using Int3 = std::array<std::int64_t, 3>;

int sign(Int128 x) {
    return (x > 0) - (x < 0);
}

int exact_sign(const Int2& a, const Int2& b, const Int2& c) {
    return sign(Int128(b[0] - a[0]) * (c[1] - a[1]) - Int128(b[1] - a[1]) * (c[0] - a[0]));
}

int exact_sign(const Int3& a, const Int3& b, const Int3& c, const Int3& d) {
    Int128 det = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const std::size_t k = (i + 2) % 3;
        det += (b[i] - a[i]) *
               (Int128(c[j] - a[j]) * (d[k] - a[k]) - Int128(c[k] - a[k]) * (d[j] - a[j]));
    }
    return sign(det);
}

/// The point with these coordinates times 2^exponent.
Vec<2> point(const Int2& x, int exponent = 0) {
    return {std::ldexp(static_cast<double>(x[0]), exponent),
            std::ldexp(static_cast<double>(x[1]), exponent)};
}
Vec<3> point(const Int3& x, int exponent = 0) {
    return {std::ldexp(static_cast<double>(x[0]), exponent),
            std::ldexp(static_cast<double>(x[1]), exponent),
            std::ldexp(static_cast<double>(x[2]), exponent)};
}

/// Nearly degenerate simplices: the last corner is near an integer combination of the others.
class Generator {
public:
    std::array<Int2, 3> triangle() {
        const Int2 a = point<2>(20), b = point<2>(20);
        const std::int64_t s = number(18);
        Int2 c;
        for (std::size_t i = 0; i < 2; ++i) {
            c[i] = a[i] + s * (b[i] - a[i]) + nudge_(random_);
        }
        return {a, b, c};
    }
    std::array<Int3, 4> tetrahedron() {
        const Int3 a = point<3>(20), b = point<3>(20), c = point<3>(20);
        const std::int64_t s = number(17), t = number(17);
        Int3 d;
        for (std::size_t i = 0; i < 3; ++i) {
            d[i] = a[i] + s * (b[i] - a[i]) + t * (c[i] - a[i]) + nudge_(random_);
        }
        return {a, b, c, d};
    }

private:
    std::int64_t number(int bits) {
        const std::int64_t limit = std::int64_t{1} << bits;
        return std::uniform_int_distribution<std::int64_t>(-limit, limit)(random_);
    }
    template <std::size_t D>
    std::array<std::int64_t, D> point(int bits) {
        std::array<std::int64_t, D> x;
        for (std::int64_t& xi : x) {
            xi = number(bits);
        }
        return x;
    }

    std::mt19937_64 random_{20240711};
    std::uniform_int_distribution<std::int64_t> nudge_{-1, 1};
};

constexpr int case_count = 50000; // for each exponent and dimension

} // namespace

class PredicatesTest : public QObject {
    Q_OBJECT
private slots:
    void knows_left_from_right();
    void knows_above_from_below();
    void agrees_with_integers_in_2d_data() { exponents(); }
    void agrees_with_integers_in_2d();
    void agrees_with_integers_in_3d_data() { exponents(); }
    void agrees_with_integers_in_3d();
    void changes_sign_with_every_exchange();
    void decides_one_rounding_beside_a_line();
    void survives_coordinates_of_any_size();
    void is_exact_where_products_underflow();
    void needs_exact_arithmetic_only_near_zero();

private:
    /// Scaling by powers of two is exact and changes no sign, but the products overflow at one end
    /// and vanish at the other.
    static void exponents() {
        QTest::addColumn<int>("exponent");
        for (const int e : {0, -60, 300, -300, 900, -1000}) {
            QTest::addRow("times 2^%d", e) << e;
        }
    }
};

void PredicatesTest::knows_left_from_right() {
    QCOMPARE(orientation(Vec<2>(0, 0), Vec<2>(1, 0), Vec<2>(0, 1)), 1);
    QCOMPARE(orientation(Vec<2>(0, 0), Vec<2>(0, 1), Vec<2>(1, 0)), -1);
    QCOMPARE(orientation(Vec<2>(0, 0), Vec<2>(1, 1), Vec<2>(3, 3)), 0);
    QCOMPARE(orientation(Vec<2>(1, 2), Vec<2>(1, 2), Vec<2>(3, 3)), 0);
}

void PredicatesTest::knows_above_from_below() {
    const Vec<3> a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
    QCOMPARE(orientation(a, b, c, Vec<3>(0, 0, 1)), 1);
    QCOMPARE(orientation(a, b, c, Vec<3>(0, 0, -1)), -1);
    QCOMPARE(orientation(a, b, c, Vec<3>(5, 7, 0)), 0);
    QCOMPARE(orientation(a, a, c, Vec<3>(5, 7, 1)), 0);
}

void PredicatesTest::agrees_with_integers_in_2d() {
    QFETCH(int, exponent);
    Generator generator;
    std::array<int, 3> seen{};
    for (int i = 0; i < case_count; ++i) {
        const auto [a, b, c] = generator.triangle();
        const int expected = exact_sign(a, b, c);
        ++seen[static_cast<std::size_t>(expected + 1)];
        QCOMPARE(orientation(point(a, exponent), point(b, exponent), point(c, exponent)), expected);
    }
    for (const int count : seen) {
        QVERIFY(count > case_count / 20); // the test meets all three answers
    }
}

void PredicatesTest::agrees_with_integers_in_3d() {
    QFETCH(int, exponent);
    Generator generator;
    std::array<int, 3> seen{};
    for (int i = 0; i < case_count; ++i) {
        const auto [a, b, c, d] = generator.tetrahedron();
        const int expected = exact_sign(a, b, c, d);
        ++seen[static_cast<std::size_t>(expected + 1)];
        QCOMPARE(orientation(point(a, exponent), point(b, exponent), point(c, exponent),
                             point(d, exponent)),
                 expected);
    }
    for (const int count : seen) {
        QVERIFY(count > case_count / 50);
    }
}

void PredicatesTest::changes_sign_with_every_exchange() {
    Generator generator;
    for (int i = 0; i < 20000; ++i) {
        const auto t = generator.tetrahedron();
        const Vec<3> a = point(t[0]), b = point(t[1]), c = point(t[2]), d = point(t[3]);
        const int s = orientation(a, b, c, d);
        QCOMPARE(orientation(b, a, c, d), -s);
        QCOMPARE(orientation(d, b, c, a), -s);
        QCOMPARE(orientation(b, c, a, d), s);
        QCOMPARE(orientation(b, a, d, c), s);
    }
}

void PredicatesTest::decides_one_rounding_beside_a_line() {
    // Kettner et al., "Classroom examples of robustness problems": points one unit in the last
    // place apart around the line y = x.
    const Vec<2> b(12, 12), c(24, 24);
    const double ulp = std::ldexp(1.0, -53);
    for (int i = 0; i < 64; ++i) {
        for (int j = 0; j < 64; ++j) {
            const Vec<2> a(0.5 + i * ulp, 0.5 + j * ulp);
            const int expected = (a[1] > a[0]) - (a[1] < a[0]);
            QCOMPARE(orientation(a, b, c), -expected * orientation(Vec<2>(1, 0), b, c));
        }
    }
}

void PredicatesTest::survives_coordinates_of_any_size() {
    const double big = std::numeric_limits<double>::max();
    const double tiny = std::numeric_limits<double>::denorm_min();
    QCOMPARE(orientation(Vec<2>(-big, -big), Vec<2>(big, -big), Vec<2>(-big, big)), 1);
    QCOMPARE(orientation(Vec<2>(-big, -big), Vec<2>(0, 0), Vec<2>(big, big)), 0);
    QCOMPARE(orientation(Vec<2>(-big, -big), Vec<2>(tiny, 0), Vec<2>(big, big)), 1);
    QCOMPARE(orientation(Vec<3>(-big, 0, 0), Vec<3>(big, 0, 0), Vec<3>(0, big, 0),
                         Vec<3>(0, -big, tiny)),
             1);
    QCOMPARE(
        orientation(Vec<3>(0, 0, 0), Vec<3>(tiny, 0, 0), Vec<3>(0, tiny, 0), Vec<3>(0, 0, tiny)),
        1);
}

void PredicatesTest::is_exact_where_products_underflow() {
    // det = b_x (c_y d_z - c_z d_y) + b_z c_x d_y = 1e200 (-5e-341) + 1.5e-220 < 0. In doubles the
    // products in the bracket are zero, and what is left is positive and looks trustworthy.
    const Vec<3> b(1e200, 0, 1e-20);
    const Vec<3> c(1e-30, 1e-170, 1e-170);
    const Vec<3> d(0, 1.5e-170, 1e-170);
    QCOMPARE(orientation(Vec<3>(0, 0, 0), b, c, d), -1);
    QCOMPARE(orientation(Vec<3>(0, 0, 0), c, b, d), 1);
    QCOMPARE(orientation(Vec<2>(0, 0), Vec<2>(1e-170, 1e-170), Vec<2>(1e-170, 1.5e-170)), 1);
}

void PredicatesTest::needs_exact_arithmetic_only_near_zero() {
    // A boundary-layer tet, aspect ratio 1e6, one unit away from the origin.
    const Vec<3> a(1, 1, 1), b(1.001, 1, 1), c(1, 1.001, 1), d(1, 1, 1 + 1e-9);
    const long long before = exact_orientation_calls();
    QCOMPARE(orientation(a, b, c, d), 1);
    QCOMPARE(exact_orientation_calls(), before);
    QCOMPARE(orientation(a, b, c, a), 0);
    QCOMPARE(exact_orientation_calls(), before + 1);
}

QTEST_APPLESS_MAIN(PredicatesTest)
#include "predicates_test.moc"
