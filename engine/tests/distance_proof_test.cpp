// SPDX-License-Identifier: MIT
// Proves the bounds of engine/distance.hpp for all inputs, in Nearest as in Saturating. Its code
// runs on numbers that represent whole cells of inputs (error_form.hpp), and the cells cover the
// domain. A cell is a range of q = (distance / length)^2 - 1 and one of the length; far from the
// length, a range of the length to which bring_near_one has scaled the difference, and one of the
// distance.
#include <gtest/gtest.h>

#include <engine/distance.hpp>

#include "error_form.hpp"

namespace proof {
namespace {

// A sanitizer checks paths and not results, so fewer cells suffice.
#ifdef SPARSE_OPERANDS
constexpr int cell_step = 7;
#else
constexpr int cell_step = 1;
#endif

// Neither distance nor length comes closer to the end of the format's range.
constexpr double share_of_range = 0.98;

// The result of bring_near_one for the difference: the range of its length, and by how many ulp a
// component is too small.
struct Scaled {
    Interval length;
    double floors = 0;
};
const Scaled* scaled = nullptr;

}  // namespace

// Replaces the engine's, which only loops: the test BringNearOne shows its result.
template <int N, int I, int F>
void bring_near_one(engine::Vector<Scalar<I, F>, N>& v) {
    if (!scaled) throw Elsewhere();
    ++path.version;
    path.q = scaled->length * scaled->length - 1;
    Number made = Number::symbol(name_of({7, v[0].name}), true, {0, 0, 1});
    made.version = path.version;
    made.error.across[made.name] = 1;
    made.error.along[made.name] = 0;
    path.box[made.name] = scaled->floors;
    for (int i = 0; i < N; ++i) v[i] = Scalar<I, F>(made);
}

namespace {

// The largest errors found: of a component of the direction, in ulp; of the excess in ulp per
// metre, beyond half an ulp for the last rounding or one ulp for each component.
struct Largest {
    double direction = 0, excess = 0;
    void take(double d, double e) {
        direction = std::max(direction, d);
        excess = std::max(excess, e);
    }
};

// l R - 1 of the ideal l R, in ulp.
Interval stretch(const Number& vector) {
    if (vector.ideal.size() != 1 || vector.ideal.begin()->first != Powers{0, 0, 1})
        throw Unproven("a direction is not near 1");
    Polynomial square = (vector.ideal * vector.ideal).at({0, 0, 0});
    square = square + Polynomial{-1};
    return range(square, path.q) / (path.of(vector.ideal) + 1) / path.ulp();
}

// The error of L P, the excess near the length, relative to L (l - 1), in units of L. Not in a
// template, where clang 19 takes Polynomial{1} for one coefficient of 0.
Interval beside_excess(const Polynomial& p) {
    const Polynomial one_more = p + Polynomial{1};
    return range(one_more * one_more + Polynomial{-1, -1}, path.q) /
           (range(one_more, path.q) + root(path.q + 1));
}

// Of a component, with |n_i| = m, over all m. With h in a box, the component of across h + along n
// (n . h) is at most |across + along m^2| + |along| m sum |n_j|, where j runs over the others.
double direction_error(const Number& direction) {
    const Number v = direction.current();
    const Interval too_long = stretch(v);
    constexpr int cells = 32;
    double most = 0;
    for (int k = 0; k < cells; ++k) {
        const Interval m(k / double(cells), (k + 1) / double(cells));
        const Interval rest = root(Interval(1) - m * m);
        if (scaled) {  // whose largest component is 1/4 to 1/2
            const double few = 2 * path.ulp();
            if (std::max(m.hi, rest.hi) * scaled->length.hi < 0.25 - few) continue;
            if (m.lo * scaled->length.lo > 0.5 + few) continue;
        }
        const Interval others = m * rest * root(Interval(path.dimensions - 1));
        Interval along_n = too_long, sum = v.error.rest;
        for (const auto& [name, factor] : v.error.single) along_n += factor * path.single.at(name);
        for (const auto& [name, across] : v.error.across) {
            const Interval along = v.error.along.at(name);
            sum += (Interval((across + along * m * m).magnitude()) +
                    Interval(along.magnitude()) * others) *
                   path.box.at(name);
        }
        sum += (along_n * m).magnitude();
        most = std::max(most, sum.hi);
    }
    return most;
}

template <class Format>
struct Proof;
template <int I, int F>
struct Proof<fixedpoint::Fixed<I, F>> {
    using Real = Scalar<I, F>;
    static constexpr double range = share_of_range * (std::uint64_t(1) << (I - 1));
    static constexpr double ulp = 1 / double(std::uint64_t(1) << F);
    static constexpr double near = 1 / double(1 << (F + 5) / 3);  // as NearOne, for the cells only

    int dimensions;
    bool sums_round_once;
    Largest near_length{}, elsewhere{};

    template <int N>
    static engine::Vector<Real, N> all_differences() {
        engine::Vector<Real, N> v;
        for (unsigned char i = 0; i < N; ++i) v[i] = Real(Number::symbol(1, true, {1, 0, 0}));
        return v;
    }
    Path start(Interval q, Interval length, Interval distance) const {
        Path made;
        made.integer_bits = I, made.fraction_bits = F, made.dimensions = dimensions;
        made.sums_round_once = sums_round_once;
        made.q = q, made.length = length, made.distance = distance;
        return made;
    }

    // The result of measure for one cell. A link that may be slack, and is not shorter, is found.
    template <bool may_be_slack, int N>
    void measure(Interval q, Interval length, int halvings) {
        Interval distance = length * root(q + 1);
        if (distance.lo > range) return;
        distance.hi = std::min(distance.hi, range);
        scaled = nullptr;
        on_all_paths(start(q, length, distance), [&] {
            Real factor(Number::symbol(factor_name, false, {0, -1, 0}, std::ldexp(1.0, halvings)));
            factor.error.single[factor.name] = 1;
            path.single[factor.name] = around(0.5);
            const auto difference = all_differences<N>();
            engine::Vector<Real, N> direction;
            Real excess;
            const bool found = engine::measure<may_be_slack>(
                difference, {}, Real(Number::symbol(3, false, {0, 1, 0})),
                {factor, static_cast<signed char>(halvings)}, direction, excess);
            if (!found) throw Unproven("a link is not found");
            note(direction[0], excess);
        });
    }
    // The exact excess is D - L = L (l - 1). The code computes L P near the length, or D l R - L.
    void note(const Number& direction, const Number& result) {
        const Number excess = result.current();
        Interval off = path.of(excess.error);
        if (const auto found = excess.ideal.find({0, 1, 0});
            found != excess.ideal.end() && excess.ideal.size() == 1) {
            off += beside_excess(found->second) * path.length / ulp;
            near_length.take(direction_error(direction), (off.magnitude() - 0.5) / path.length.hi);
        } else {
            off += stretch(direction.current()) * path.distance;
            elsewhere.take(direction_error(direction),
                           (off.magnitude() - 0.5 * dimensions) / path.distance.hi);
        }
    }
    template <int N>
    void measure_from_near_one(const Scaled& from, Interval distance) {
        scaled = &from;
        on_all_paths(start(0, 0, distance), [&] {
            engine::Vector<Real, N> direction;
            const auto difference = all_differences<N>();
            const Real found = engine::measure_by_steps(
                difference, {}, Real::from_raw(typename Real::Raw(1) << F), direction);
            note(direction[0], found);
        });
        scaled = nullptr;
    }

    // A length of 2^-k m takes doublings, which are exact: its error is below that of the products.
    template <int N>
    void all() {
        for (int halvings = 0; halvings < I - 1; halvings += cell_step) {
            const double shortest = halvings == 0 ? std::max(std::ldexp(1.0, 2 - I), 4 * ulp)
                                                  : std::ldexp(1.0, halvings);
            const double longest = std::min(std::ldexp(2.0, halvings), range);
            for (double from = shortest, to; from < longest; from = to) {
                to = std::min((from < 0.25 ? 4 : 2) * from, longest);
                of_length<N>({from, to}, halvings);
            }
        }
        for (int i = 62; i < 230; i += cell_step) {
            const Interval length(i / 256.0, (i + 1) / 256.0);
            const Scaled from{length, length.hi < 0.5 - 2 * ulp ? 1.0 : 2.0};
            measure_from_near_one<N>(from, 1);  // m: the distance is linear in that
        }
    }
    template <int N>
    void of_length(Interval length, int halvings) {
        const auto both = [&](double from, double to) {
            for (Interval q : {Interval(from, to), Interval(std::max(-to, -1.0), -from)}) {
                if (q.lo > q.hi) continue;
                measure<false, N>(q, length, halvings);
                if (q.lo >= 0) measure<true, N>(q, length, halvings);
            }
        };
        double q = 0;
        if (halvings == 0)
            for (; q < 24 * ulp; q += ulp) both(q, q + ulp);
        else
            for (; q < near; q += near / 2) both(q, q + near / 2);
        // Up to where the square leaves the format. Beyond |q| = 1/2 the code starts again, and a
        // few wide cells show that it does.
        for (double to; q < range - 1; q = to) {
            to = q < 0.51 ? q + std::min(q / 8, 1.0 / 128) : std::min(1.25 * q, range - 1);
            both(q, to);
        }
    }
};

// Near the length, and elsewhere.
struct Bounds {
    Largest near_length, elsewhere;
};
template <class Format, int N>
void expect_within(const Bounds& bounds, bool sums_round_once) {
    Proof<Format> proof{N, sums_round_once};
    proof.template all<N>();
    EXPECT_LE(proof.near_length.direction, bounds.near_length.direction) << N;
    EXPECT_LE(proof.near_length.excess, bounds.near_length.excess) << N;
    EXPECT_LE(proof.elsewhere.direction, bounds.elsewhere.direction) << N;
    EXPECT_LE(proof.elsewhere.excess, bounds.elsewhere.excess) << N;
    // The proof must not fail for lack of cells.
    if (cell_step > 1) return;
    EXPECT_GT(proof.near_length.excess, 0.75 * bounds.near_length.excess) << N;
    EXPECT_GT(proof.elsewhere.excess, 0.75 * bounds.elsewhere.excess) << N;
}
constexpr Bounds nearest = {{8.5, 3}, {10.75, 3.25}};

TEST(DistanceProof, HoldsInNearest) {
    expect_within<fixedpoint::Fixed<16, 16>, 2>(nearest, true);
#ifndef SPARSE_OPERANDS
    expect_within<fixedpoint::Fixed<16, 16>, 3>(nearest, true);
#endif
}
#ifndef SPARSE_OPERANDS
constexpr Bounds saturating = {{9, 3.5}, {11.25, 5}};
TEST(DistanceProof, HoldsInSaturating) {
    expect_within<fixedpoint::Fixed<16, 16>, 2>(saturating, false);
    expect_within<fixedpoint::Fixed<16, 16>, 3>(saturating, false);
}
TEST(DistanceProof, HoldsWithMoreFractionBits) {
    expect_within<fixedpoint::Fixed<8, 24>, 3>(saturating, false);
}
#endif

// What the proof assumes of 1 / length: half an ulp, for all lengths of less than 2 m, and for
// those at the ends of each other number of halvings.
TEST(DistanceProof, InverseIsRoundedOnce) {
    const auto check = [](std::int64_t raw) {
        const auto made =
            engine::inverse_of(fixedpoint::Fixed<16, 16>::from_raw(static_cast<std::int32_t>(raw)));
        if (made.halvings < 0) {  // exact
            ASSERT_EQ(made.factor.raw(), 1 << 16);
            ASSERT_EQ(raw, (1 << 16) >> (-1 - made.halvings));
            return;
        }
        const std::int64_t twice = 2 * (std::int64_t(1) << (32 + made.halvings));
        ASSERT_LE(std::abs(twice - 2 * raw * made.factor.raw()), raw) << raw;
        ASSERT_EQ(made.halvings == 0, raw < 1 << 17) << raw;
        ASSERT_LE(made.factor.raw() >> (made.halvings == 0 ? 15 : 0), 1 << 16) << raw;
    };
    for (std::int64_t raw = 4; raw < 1 << 18; ++raw) check(raw);
    for (int bits = 18; bits < 31; ++bits) {
        for (std::int64_t i = 0; i < 1000; ++i) {
            check((std::int64_t(1) << bits) + i);
            check((std::int64_t(2) << bits) - 1 - i);
        }
    }
}
// What it assumes of bring_near_one: the difference times a power of two, rounded down by less than
// `floors` ulp, with its largest component in 1/4..1/2. For all components of 16 bits, next to some
// others.
TEST(DistanceProof, BringNearOneScales) {
    using Small = fixedpoint::Fixed<8, 8>;
    for (int a = -32768; a < 32768; ++a) {
        for (int b : {0, 1, -1, 77, -4097, 32767, a / 3, -a}) {
            if (b < -32768 || b > 32767 || (a == 0 && b == 0)) continue;
            engine::Vector<Small, 2> v;
            v[0] = Small::from_raw(static_cast<std::int16_t>(a));
            v[1] = Small::from_raw(static_cast<std::int16_t>(b));
            engine::bring_near_one(v);
            const int x = v[0].raw(), y = v[1].raw(), most = std::max(std::abs(x), std::abs(y));
            ASSERT_TRUE(64 <= most && most <= 128) << a << " " << b;
            bool scales = false;
            for (int k = -16; k <= 8 && !scales; ++k) {
                const double scale = std::ldexp(1.0, k), low_x = a * scale - x,
                             low_y = b * scale - y,
                             floors = most == 128 ? 2
                                      : k < 0     ? 1
                                                  : 1e-9;
                scales = low_x >= 0 && low_y >= 0 && low_x < floors && low_y < floors;
            }
            ASSERT_TRUE(scales) << a << " " << b;
        }
    }
}

}  // namespace
}  // namespace proof
