// SPDX-License-Identifier: GPL-3.0-or-later
// AnyFormat: a fixed-point number whose width and split are chosen at run time, so that one
// instance of the engine runs in every format. Its results are those of Fixed in the default
// arithmetic, except for roots (the lengths of springs, and the distances of touching spheres in
// other formats than Q16.16), which are correctly rounded here and within 1 ulp there. It
// reports to the recorder what Checked would report, and the magnitude of each result before it
// wraps.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <engine/decimal.hpp>
#include <engine/overlap.hpp>
#include <engine/solvers/warm_started.hpp>
#include <engine/time_step.hpp>
#include <engine/validity.hpp>

#include "bench/experiments/stability/recorder.hpp"

namespace stability {

struct Split {
    int integer_bits = 16, fraction_bits = 16;
    int width() const { return integer_bits + fraction_bits; }
    std::int64_t most() const {
        return static_cast<std::int64_t>((std::uint64_t(1) << (width() - 1)) - 1);
    }
};

class AnyFormat {
  public:
    using Wide = __int128;
    using Event = fixedpoint::Event;
    using Operation = fixedpoint::Operation;

    AnyFormat() = default;
    explicit AnyFormat(std::int64_t n)
        : AnyFormat(wrapped(Wide(n) << fraction(), Operation::convert)) {}
    static AnyFormat from_raw(std::int64_t raw) {
        AnyFormat made;
        made.raw_ = raw;
        return made;
    }
    std::int64_t raw() const { return raw_; }

    // The split of this thread's numbers.
    static Split& split() {
        static thread_local Split one;
        return one;
    }

    friend AnyFormat operator+(AnyFormat a, AnyFormat b) {
        return wrapped(Wide(a.raw_) + b.raw_, Operation::add);
    }
    friend AnyFormat operator-(AnyFormat a, AnyFormat b) {
        return wrapped(Wide(a.raw_) - b.raw_, Operation::subtract);
    }
    AnyFormat operator-() const { return wrapped(-Wide(raw_), Operation::negate); }
    friend AnyFormat operator*(AnyFormat a, AnyFormat b) {
        return product(Wide(a.raw_) * b.raw_, a.raw_ != 0 && b.raw_ != 0, Operation::multiply);
    }
    friend AnyFormat operator/(AnyFormat a, AnyFormat b) {
        if (b.raw_ == 0) {
            tell(Event::division_by_zero, Operation::divide);
            return a.raw_ == 0 ? AnyFormat() : saturated(a.raw_ < 0 ? -limit() - 1 : limit());
        }
        // floor(a / b + 1/2) for a positive divisor b: floor((a + floor(b / 2)) / b), since there
        // is no tie for odd b.
        const Wide numerator = (Wide(a.raw_) << fraction()) * (b.raw_ < 0 ? -1 : 1);
        const Wide divisor = b.raw_ < 0 ? -Wide(b.raw_) : Wide(b.raw_);
        const Wide quotient = floored(numerator + divisor / 2, divisor);
        if (quotient != saturated(quotient).raw_) tell(Event::overflow, Operation::divide);
        if (quotient == 0 && a.raw_ != 0) tell(Event::underflow, Operation::divide);
        return saturated(quotient);
    }
    AnyFormat& operator+=(AnyFormat b) { return *this = *this + b; }
    AnyFormat& operator-=(AnyFormat b) { return *this = *this - b; }
    AnyFormat& operator*=(AnyFormat b) { return *this = *this * b; }
    AnyFormat& operator/=(AnyFormat b) { return *this = *this / b; }
    friend bool operator==(AnyFormat a, AnyFormat b) { return a.raw_ == b.raw_; }
    friend bool operator<(AnyFormat a, AnyFormat b) { return a.raw_ < b.raw_; }
    friend bool operator>(AnyFormat a, AnyFormat b) { return a.raw_ > b.raw_; }
    friend bool operator<=(AnyFormat a, AnyFormat b) { return a.raw_ <= b.raw_; }
    friend bool operator>=(AnyFormat a, AnyFormat b) { return a.raw_ >= b.raw_; }

    // What the engine requires of a scalar in addition to its operators (engine/scalar.hpp).
    template <int N>
    friend AnyFormat dot(const AnyFormat* a, const AnyFormat* b) {
        Wide sum = 0;
        for (int i = 0; i < N; ++i) sum += Wide(a[i].raw_) * b[i].raw_;
        return product(sum, false, Operation::dot);
    }
    template <int N>
    friend AnyFormat length(const AnyFormat* v) {
        unsigned __int128 sum = 0;
        for (int i = 0; i < N; ++i)
            sum += static_cast<unsigned __int128>(Wide(v[i].raw_) * v[i].raw_);
        const Wide root = rounded_root(sum);
        if (root > limit()) tell(Event::overflow, Operation::length);
        return saturated(root);
    }
    friend AnyFormat sqrt(AnyFormat a) {
        if (a.raw_ < 0) tell(Event::domain_error, Operation::sqrt);
        if (a.raw_ <= 0) return AnyFormat();
        return from_raw(static_cast<std::int64_t>(
            rounded_root(static_cast<unsigned __int128>(a.raw_) << fraction())));
    }
    static AnyFormat multiply_add(AnyFormat a, AnyFormat b, AnyFormat c) {
        const Wide exact = Wide(a.raw_) * b.raw_;
        if (a.raw_ != 0 && b.raw_ != 0 && rounded(exact, fraction()) == 0)
            tell(Event::underflow, Operation::multiply_add);
        return product(exact + (Wide(c.raw_) << fraction()), false, Operation::multiply_add);
    }
    // As engine::half, which rounds down.
    friend AnyFormat half(AnyFormat a) { return from_raw(a.raw_ >> 1); }
    // As engine::inverse_of: factor / 2^halvings.
    friend engine::Inverse<AnyFormat> inverse_of(AnyFormat a) {
        if (!(a > AnyFormat())) return {AnyFormat(), 0};
        signed char halvings = 0;
        for (std::int64_t left = a.raw_ >> fraction() >> 1; left != 0; left >>= 1) ++halvings;
        const Wide divisor = a.raw_;
        const Wide factor = ((Wide(2) << (2 * fraction() + halvings)) / divisor + 1) >> 1;
        if (factor > limit()) return {AnyFormat(), 0};
        if (halvings == 0 && (divisor & (divisor - 1)) == 0) {
            halvings = -1;
            for (Wide left = factor >> fraction(); left > 1; left >>= 1) --halvings;
            return {from_raw(std::int64_t(1) << fraction()), halvings};
        }
        return {from_raw(static_cast<std::int64_t>(factor)), halvings};
    }
    // floor((a + residual) / 2^count) and the remainder, as engine::carried_shift.
    static AnyFormat carried_shift(AnyFormat a, int count, AnyFormat& residual) {
        const std::int64_t sum = saturating_sum(a, residual).raw_;
        const bool holds = count < split().width() - 1;
        residual = from_raw(holds ? sum & ((std::int64_t(1) << count) - 1) : 0);
        return from_raw(sum >> std::min(count, 63));
    }
    friend AnyFormat saturating_sum(AnyFormat a, AnyFormat b) {
        return saturated(Wide(a.raw_) + b.raw_);
    }
    friend AnyFormat saturating_product(AnyFormat a, AnyFormat b) {
        return saturated(rounded(Wide(a.raw_) * b.raw_, fraction()));
    }
    // a / 2^count.
    friend AnyFormat scaled_down(AnyFormat a, int count) {
        const AnyFormat result = from_raw(static_cast<std::int64_t>(rounded(a.raw_, count)));
        if (result.raw_ == 0 && a.raw_ != 0) tell(Event::underflow, Operation::scale_down);
        return result;
    }

    // As the product of Fixed: the step in seconds is a quotient whose divisor may not fit.
    template <int K>
    friend AnyFormat operator*(AnyFormat a, engine::BinaryStep<K>) {
        return scaled_down(a, K);
    }

    // x rounded half up, and whether it fits.
    static AnyFormat nearest(double x, bool& fits) {
        const double scaled = std::floor(std::ldexp(x, fraction()) + 0.5);
        fits = std::abs(scaled) <= static_cast<double>(split().most());
        return fits ? from_raw(static_cast<std::int64_t>(scaled)) : AnyFormat();
    }

  private:
    std::int64_t raw_ = 0;

    static int fraction() { return split().fraction_bits; }
    static Wide limit() { return split().most(); }
    static void tell(Event event, Operation operation) { Hook::notify(event, operation); }

    static Wide floored(Wide a, Wide divisor) {
        const Wide quotient = a / divisor;
        return a % divisor < 0 ? quotient - 1 : quotient;
    }
    static Wide rounded(Wide a, int count) {
        return count == 0 ? a : (a + (Wide(1) << (count - 1))) >> count;
    }
    static AnyFormat saturated(Wide raw) {
        return from_raw(static_cast<std::int64_t>(raw > limit()        ? limit()
                                                  : raw < -limit() - 1 ? -limit() - 1
                                                                       : raw));
    }
    static AnyFormat wrapped(Wide raw, Operation operation) {
        // The most negative number fits, although its magnitude does not.
        if (Recorder* recorder = active_recorder())
            recorder->result.include(
                std::ldexp(static_cast<double>(raw < 0 ? raw + 1 : raw), -fraction()));
        const AnyFormat fitting = saturated(raw);
        if (fitting.raw_ == raw) return fitting;
        tell(Event::overflow, operation);
        const int spare = 64 - split().width();
        const auto low = static_cast<std::uint64_t>(raw) << spare;
        return from_raw(static_cast<std::int64_t>(low) >> spare);
    }
    static AnyFormat product(Wide exact, bool watched, Operation operation) {
        const AnyFormat result = wrapped(rounded(exact, fraction()), operation);
        if (watched && result.raw_ == 0) tell(Event::underflow, operation);
        return result;
    }
    // The nearest integer to the square root.
    static Wide rounded_root(unsigned __int128 square) {
        unsigned __int128 root = 0;
        for (int bit = 64; bit >= 0; --bit) {
            const unsigned __int128 candidate = root | (static_cast<unsigned __int128>(1) << bit);
            if (bit < 64 && candidate * candidate <= square) root = candidate;
        }
        return static_cast<Wide>(square - root * root > root ? root + 1 : root);
    }
};

}  // namespace stability

namespace engine {

template <int64_t digits, unsigned char places>
struct DecimalIn<stability::AnyFormat, digits, places> {
    static stability::AnyFormat value() {
        bool fits;
        return stability::AnyFormat::nearest(digits / std::pow(10.0, places), fits);
    }
};

template <>
struct MultiplyAdd<stability::AnyFormat> {
    using Number = stability::AnyFormat;
    static Number of(Number a, Number b, Number c) { return Number::multiply_add(a, b, c); }
};

template <>
struct NormalTolerance<stability::AnyFormat> {
    static stability::AnyFormat value() {
        const int fraction = stability::AnyFormat::split().fraction_bits;
        return stability::AnyFormat::from_raw(fraction > 10 ? std::int64_t(1) << (fraction - 8)
                                                            : 4);
    }
};

// How Fixed measures rods, ropes and, in Q16.16, overlapping spheres: engine/distance.hpp and
// overlap.hpp, with a split known at run time.

template <>
struct NearOne<stability::AnyFormat> {
    static stability::AnyFormat value() {
        const int fraction = stability::AnyFormat::split().fraction_bits;
        return stability::AnyFormat::from_raw(
            std::int64_t(1) << (fraction < 2 ? 0 : fraction - (fraction + 5) / 3));
    }
};

template <>
struct RestingGap<stability::AnyFormat> {
    static stability::AnyFormat value() {
        return stability::AnyFormat::from_raw(
            stability::AnyFormat::split().fraction_bits >= 12 ? 8 : 1);
    }
};

inline stability::AnyFormat times(stability::AnyFormat a,
                                  const Inverse<stability::AnyFormat>& inverse) {
    signed char i = inverse.halvings;
    if (i < 0) {
        while (++i != 0) a += a;
    } else {
        a *= inverse.factor;
        for (; i != 0; --i) a = half(a);
    }
    return a;
}
template <int N>
void scale(Vector<stability::AnyFormat, N>& v, const Inverse<stability::AnyFormat>& inverse) {
    for (unsigned char i = 0; i < N; ++i) v[i] = times(v[i], inverse);
}

template <int N>
void bring_near_one(Vector<stability::AnyFormat, N>& v) {
    using Number = stability::AnyFormat;
    const int fraction = Number::split().fraction_bits;
    const Number quarter = Number::from_raw(std::int64_t(1) << (fraction < 2 ? 0 : fraction - 2));
    for (;;) {
        Number least = Number();  // -|v_i| of the largest; |v_i| itself may not fit
        for (unsigned char i = 0; i < N; ++i) {
            const Number below_zero = v[i] > Number() ? -v[i] : v[i];
            if (below_zero < least) least = below_zero;
        }
        if (least < -(quarter + quarter)) {
            halve(v);
        } else if (least < -quarter || least == Number()) {
            return;
        } else {
            for (unsigned char i = 0; i < N; ++i) v[i] += v[i];
        }
    }
}

template <int N>
bool measure_scaled(const Vector<stability::AnyFormat, N>& first,
                    const Vector<stability::AnyFormat, N>& second, stability::AnyFormat length,
                    const Inverse<stability::AnyFormat>& inverse, stability::AnyFormat e,
                    stability::AnyFormat little, Vector<stability::AnyFormat, N>& direction,
                    stability::AnyFormat& excess) {
    using Number = stability::AnyFormat;
    if (inverse.halvings <= 0 && absolute(e) < NearOne<Number>::value()) {
        if (absolute(e) > little) e = mend_length(direction, e);
        excess = short_product(e, length);
        return true;
    }
    const Number distance = measure_by_steps(first, second, e, direction);
    excess = distance - length;
    return !(distance == Number());
}
template <bool may_be_slack, int N>
bool measure(const Vector<stability::AnyFormat, N>& first,
             const Vector<stability::AnyFormat, N>& second, const stability::AnyFormat& length,
             const Inverse<stability::AnyFormat>& inverse,
             Vector<stability::AnyFormat, N>& direction, stability::AnyFormat& excess) {
    using Number = stability::AnyFormat;
    direction = first - second;
    scale(direction, inverse);
    const Number e = excess_over_one(direction);
    if (may_be_slack && e < -NearOne<Number>::value()) return false;
    const Number little = Number::from_raw(Number::split().fraction_bits >= 12 ? 4 : 0);
    return measure_scaled(first, second, length, inverse, e, little, direction, excess);
}
template <int N>
stability::AnyFormat overlap(const Vector<stability::AnyFormat, N>& first,
                             const Vector<stability::AnyFormat, N>& second,
                             stability::AnyFormat reach, LastReach<stability::AnyFormat, true>&,
                             Vector<stability::AnyFormat, N>& direction) {
    using Number = stability::AnyFormat;
    if (Number::split().integer_bits != 16 || Number::split().fraction_bits != 16) {
        const Number distance = engine::length(direction);
        if (!(distance < reach)) return Number();
        direction = divided(direction, distance);
        if (distance == Number()) direction[0] = Decimal<1, 0>();
        return reach - distance;
    }
    const Inverse<Number> inverse = inverse_of(reach);
    scale(direction, inverse);
    const Number e = excess_over_one(direction);
    Number excess = {};
    if (!(e < excess)) return excess;
    if (!measure_scaled(first, second, reach, inverse, e, Number(), direction, excess))
        direction[0] = Decimal<1, 0>();
    return -excess;
}

}  // namespace engine
