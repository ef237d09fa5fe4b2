// SPDX-License-Identifier: GPL-3.0-or-later
// AnyFormat: a fixed-point number whose width and split are chosen at run time, so that one
// instance of the engine runs in every format. Its results are those of Fixed in the default
// arithmetic, except for lengths, which are correctly rounded here and within 1 ulp there. It
// reports to the recorder what Checked would report.
#pragma once

#include <cmath>
#include <cstdint>
#include <engine/decimal.hpp>
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
    static AnyFormat multiply_add(AnyFormat a, AnyFormat b, AnyFormat c) {
        const Wide exact = Wide(a.raw_) * b.raw_;
        if (a.raw_ != 0 && b.raw_ != 0 && rounded(exact, fraction()) == 0)
            tell(Event::underflow, Operation::multiply_add);
        return product(exact + (Wide(c.raw_) << fraction()), false, Operation::multiply_add);
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

}  // namespace engine
