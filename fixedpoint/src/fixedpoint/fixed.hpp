// SPDX-License-Identifier: MIT
/// \file
/// Fixed<IntegerBits, FractionBits, Arithmetic>: a signed fixed-point number, value = raw / 2^F, in
/// a two's-complement integer of IntegerBits + FractionBits = 8, 16, 24, 32 or 64 bits. The sign
/// counts as an integer bit; unsigned.hpp has numbers without one. Arithmetic decides how results
/// are rounded and what happens to those out of range; arithmetic/nearest.hpp states the rule that
/// the default follows for every input.
///
/// Both operands of an operator must have the same format and arithmetic, or one must be an
/// integer. An integer keeps its exact value even if the format cannot represent it; only the
/// result must be in range. No conversion is implicit: use a literal from literals.hpp,
/// from_integer or from_raw, and conversion.hpp for everything else.
#pragma once

#include <fixedpoint/arithmetic/nearest.hpp>
#include <fixedpoint/builtin.hpp>
#include <fixedpoint/integer.hpp>
#include <fixedpoint/portable/integer_operand.hpp>

namespace fixedpoint {

/// \cond internal
struct convert_one_operand_to_the_format_of_the_other;
/// \endcond

/// A number raw / 2^FractionBits. The comment at the top of this file explains the parameters;
/// README.md lists what each operation returns for every input.
template <int IntegerBits, int FractionBits, class ArithmeticPolicy = Nearest>
class Fixed {
    static_assert(IntegerBits >= 1 ||
                      !RawTypeOf<IntegerBits + FractionBits, ArithmeticPolicy>::is_signed,
                  "IntegerBits counts the sign and must be at least 1: choose a smaller unit, so "
                  "that the binary point is inside the integer.");
    static_assert(
        IntegerBits >= 0,
        "IntegerBits must not be negative: choose a smaller unit, so that the binary point "
        "is inside the integer.");
    static_assert(
        FractionBits >= 0,
        "FractionBits must not be negative: choose a larger unit, so that the binary point "
        "is inside the integer.");
    static_assert(
        RawTypeOf<IntegerBits + FractionBits, ArithmeticPolicy>::is_signed ||
            IntegerBits + FractionBits < 64 || (IntegerBits > 0 && FractionBits > 0),
        "An unsigned number of 64 bits has 1 to 63 fraction bits: decimal text needs a bit "
        "more than the number.");

  public:
    /// The integer of IntegerBits + FractionBits bits: int8_t, int16_t, Int24, int32_t or int64_t,
    /// in two's complement; of a UFixed, uint8_t, uint16_t, uint32_t or uint64_t.
    using Raw = RawOf<IntegerBits + FractionBits, ArithmeticPolicy>;
    /// The arithmetic, which rounds results and decides what happens to those out of range.
    using Arithmetic = ArithmeticPolicy;
    /// The bits before the binary point, including the sign.
    static constexpr int integer_bits = IntegerBits;
    /// The bits after the binary point: adjacent numbers are 2^-fraction_bits apart.
    static constexpr int fraction_bits = FractionBits;

    /// The number 0.
    constexpr Fixed() : raw_(0) {}

    /// The number raw / 2^F.
    static constexpr Fixed from_raw(Raw raw) { return Fixed(raw, Private()); }
    /// The number times 2^FractionBits, an integer.
    constexpr Raw raw() const { return raw_; }

    /// The integer n, of any integer type. If the format cannot represent it, the arithmetic
    /// decides: Nearest takes n 2^F modulo 2^W, Saturating returns the nearest number, Checked
    /// wraps as Nearest does and notifies its hook.
    template <class Integral>
    static constexpr Fixed from_integer(Integral n) {
        static_assert(BuiltinNumber<Integral>::is_integer,
                      "from_integer takes an integer: use from_float for a float or double, and "
                      "convert for a fixed-point number.");
        return from_raw(Arithmetic::template convert<Raw, FractionBits, Integral, 0>(n));
    }

    /// The largest number.
    static constexpr Fixed max() { return from_raw(RawLimits<Raw>::max); }
    /// The smallest number. Its negative is out of range.
    static constexpr Fixed min() { return from_raw(RawLimits<Raw>::min); }
    /// The distance between adjacent numbers, one unit in the last place.
    static constexpr Fixed ulp() { return from_raw(1); }

    /// The exact sum. If it is out of range, the arithmetic decides (Nearest: modulo 2^W).
    friend constexpr Fixed operator+(Fixed a, Fixed b) {
        return from_raw(Arithmetic::template add<Raw, FractionBits>(a.raw_, b.raw_));
    }
    /// The exact difference. If it is out of range, the arithmetic decides (Nearest: modulo 2^W).
    friend constexpr Fixed operator-(Fixed a, Fixed b) {
        return from_raw(Arithmetic::template subtract<Raw, FractionBits>(a.raw_, b.raw_));
    }
    /// The product, rounded once. If it is out of range, the arithmetic decides (Nearest: modulo
    /// 2^W).
    friend constexpr Fixed operator*(Fixed a, Fixed b) {
        return from_raw(Arithmetic::template multiply<Raw, FractionBits>(a.raw_, b.raw_));
    }
    /// The quotient, rounded once and saturated; a / 0 is the largest number, the smallest, or 0,
    /// by the sign of a.
    friend constexpr Fixed operator/(Fixed a, Fixed b) {
        return from_raw(Arithmetic::template divide<Raw, FractionBits>(a.raw_, b.raw_));
    }
    /// The exact remainder a - b trunc(a / b), which is 0 or has the sign of a; a % 0 is a.
    friend constexpr Fixed operator%(Fixed a, Fixed b) {
        return from_raw(Arithmetic::template remainder<Raw, FractionBits>(a.raw_, b.raw_));
    }
    /// The exact negative. That of the smallest number is out of range, so the arithmetic decides
    /// (Nearest: the number itself).
    constexpr Fixed operator-() const {
        return from_raw(Arithmetic::template negate<Raw, FractionBits>(raw_));
    }
    /// The number itself.
    constexpr Fixed operator+() const { return *this; }

    /// a 2^count. If it is out of range, the arithmetic decides (Nearest: modulo 2^W, 0 from count
    /// = W on). The count may have any integer type. A negative one counts as larger than W, which
    /// it is once converted to unsigned; all counts from W on give the same result.
    template <class Count>
    friend constexpr Fixed operator<<(Fixed a, Count count) {
        return from_raw(
            Arithmetic::template shift_left<Raw, FractionBits>(a.raw_, shift_count(count)));
    }
    /// a / 2^count, rounded downward. The count may have any integer type; from W on, and if it is
    /// negative, the result is 0, or -1 ulp if a < 0.
    template <class Count>
    friend FIXEDPOINT_CONSTEXPR Fixed operator>>(Fixed a, Count count) {
        constexpr unsigned char last = RawLimits<Raw>::width - 1;
        return from_raw(
            !RawLimits<Raw>::is_signed && shift_count(count) > last
                ? Raw(0)
                : static_cast<Raw>(a.raw_ >>
                                   (shift_count(count) < last ? shift_count(count) : last)));
    }

    /// The exact sum. If it is out of range, the arithmetic decides (Nearest: modulo 2^W).
    /// @{
    template <class Int>
    friend constexpr typename BesideInteger<Int, Fixed>::Type operator+(Fixed a, Int n) {
        return from_raw(Arithmetic::settle(portable::add_integer<Raw, FractionBits>(a.raw_, n),
                                           portable::sum_fits<Raw, FractionBits>(a.raw_, n),
                                           !portable::is_negative_integer(n), Operation::add));
    }
    template <class Int>
    friend constexpr typename BesideInteger<Int, Fixed>::Type operator+(Int n, Fixed a) {
        return a + n;
    }
    /// @}
    /// The exact difference. If it is out of range, the arithmetic decides (Nearest: modulo 2^W).
    /// @{
    template <class Int>
    friend constexpr typename BesideInteger<Int, Fixed>::Type operator-(Fixed a, Int n) {
        return from_raw(
            Arithmetic::settle(wrapping_subtract(a.raw_, portable::scale<Raw, FractionBits>(n)),
                               portable::difference_fits<Raw, FractionBits>(a.raw_, n),
                               portable::is_negative_integer(n), Operation::subtract));
    }
    template <class Int>
    friend constexpr typename BesideInteger<Int, Fixed>::Type operator-(Int n, Fixed a) {
        return from_raw(Arithmetic::settle(
            wrapping_subtract(portable::scale<Raw, FractionBits>(n), a.raw_),
            portable::DifferenceFrom<Raw, FractionBits, Int>::fits(a.raw_, n),
            portable::DifferenceFrom<Raw, FractionBits, Int>::is_above(a.raw_, n),
            Operation::subtract));
    }
    /// @}
    /// The exact product. If it is out of range, the arithmetic decides (Nearest: modulo 2^W).
    /// @{
    template <class Int>
    friend constexpr typename BesideInteger<Int, Fixed>::Type operator*(Fixed a, Int n) {
        return from_raw(Arithmetic::settle(
            portable::multiply_integer(a.raw_, n), portable::product_fits(a.raw_, n),
            (a.raw_ < 0) == portable::is_negative_integer(n), Operation::multiply));
    }
    template <class Int>
    friend constexpr typename BesideInteger<Int, Fixed>::Type operator*(Int n, Fixed a) {
        return a * n;
    }
    /// @}
    /// The quotient, rounded once and saturated; a / 0 is the largest number, the smallest, or 0,
    /// by the sign of a. An integer divided by a number does not compile: the integer could be out
    /// of range although the quotient is in range.
    template <class Int>
    friend constexpr typename BesideInteger<Int, Fixed>::Type operator/(Fixed a, Int n) {
        return from_raw(portable::divide_integer<Arithmetic>(a.raw_, n));
    }

    /// Assigns the result of the binary operator to this number.
    /// @{
    FIXEDPOINT_CONSTEXPR Fixed& operator+=(Fixed b) { return *this = *this + b; }
    FIXEDPOINT_CONSTEXPR Fixed& operator-=(Fixed b) { return *this = *this - b; }
    FIXEDPOINT_CONSTEXPR Fixed& operator*=(Fixed b) { return *this = *this * b; }
    FIXEDPOINT_CONSTEXPR Fixed& operator/=(Fixed b) { return *this = *this / b; }
    FIXEDPOINT_CONSTEXPR Fixed& operator%=(Fixed b) { return *this = *this % b; }
    template <class Int>
    FIXEDPOINT_CONSTEXPR typename BesideInteger<Int, Fixed&>::Type operator+=(Int n) {
        return *this = *this + n;
    }
    template <class Int>
    FIXEDPOINT_CONSTEXPR typename BesideInteger<Int, Fixed&>::Type operator-=(Int n) {
        return *this = *this - n;
    }
    template <class Int>
    FIXEDPOINT_CONSTEXPR typename BesideInteger<Int, Fixed&>::Type operator*=(Int n) {
        return *this = *this * n;
    }
    template <class Int>
    FIXEDPOINT_CONSTEXPR typename BesideInteger<Int, Fixed&>::Type operator/=(Int n) {
        return *this = *this / n;
    }
    template <class Count>
    FIXEDPOINT_CONSTEXPR Fixed& operator<<=(Count count) {
        return *this = *this << count;
    }
    template <class Count>
    FIXEDPOINT_CONSTEXPR Fixed& operator>>=(Count count) {
        return *this = *this >> count;
    }
    /// @}

    /// Compares the values, exactly. Every pair of numbers is ordered.
    /// @{
    friend constexpr bool operator==(Fixed a, Fixed b) { return a.raw_ == b.raw_; }
    friend constexpr bool operator!=(Fixed a, Fixed b) { return a.raw_ != b.raw_; }
    friend constexpr bool operator<(Fixed a, Fixed b) { return a.raw_ < b.raw_; }
    friend constexpr bool operator>(Fixed a, Fixed b) { return a.raw_ > b.raw_; }
    friend constexpr bool operator<=(Fixed a, Fixed b) { return a.raw_ <= b.raw_; }
    friend constexpr bool operator>=(Fixed a, Fixed b) { return a.raw_ >= b.raw_; }
    /// @}

    /// Compares the values, exactly, even if the integer is out of range.
    /// @{
    template <class Int>
    friend constexpr typename BesideInteger<Int, bool>::Type operator==(Fixed a, Int n) {
        return holds(n) && a.raw_ == portable::scale<Raw, FractionBits>(n);
    }
    template <class Int>
    friend constexpr typename BesideInteger<Int, bool>::Type operator<(Fixed a, Int n) {
        return holds(n) ? a.raw_ < portable::scale<Raw, FractionBits>(n)
                        : !portable::is_negative_integer(n);
    }
    template <class Int>
    friend constexpr typename BesideInteger<Int, bool>::Type operator>(Fixed a, Int n) {
        return holds(n) ? a.raw_ > portable::scale<Raw, FractionBits>(n)
                        : portable::is_negative_integer(n);
    }
    template <class Int>
    friend constexpr typename BesideInteger<Int, bool>::Type operator!=(Fixed a, Int n) {
        return !(a == n);
    }
    template <class Int>
    friend constexpr typename BesideInteger<Int, bool>::Type operator<=(Fixed a, Int n) {
        return !(a > n);
    }
    template <class Int>
    friend constexpr typename BesideInteger<Int, bool>::Type operator>=(Fixed a, Int n) {
        return !(a < n);
    }
    template <class Int>
    friend constexpr typename BesideInteger<Int, bool>::Type operator==(Int n, Fixed a) {
        return a == n;
    }
    template <class Int>
    friend constexpr typename BesideInteger<Int, bool>::Type operator!=(Int n, Fixed a) {
        return !(a == n);
    }
    template <class Int>
    friend constexpr typename BesideInteger<Int, bool>::Type operator<(Int n, Fixed a) {
        return a > n;
    }
    template <class Int>
    friend constexpr typename BesideInteger<Int, bool>::Type operator>(Int n, Fixed a) {
        return a < n;
    }
    template <class Int>
    friend constexpr typename BesideInteger<Int, bool>::Type operator<=(Int n, Fixed a) {
        return !(a < n);
    }
    template <class Int>
    friend constexpr typename BesideInteger<Int, bool>::Type operator>=(Int n, Fixed a) {
        return !(a > n);
    }
    /// @}

    /// Other mixed operands do not compile. A product of two formats would hide in which of them it
    /// is rounded. With a float, either the float would be rounded before the arithmetic sees it or
    /// the number would become a float. A character or a bool is not a quantity. Integers do not
    /// convert implicitly either, since the format might not represent them.
    template <class Number,
              class write_a_literal_or_from_integer_or_from_float =
                  typename BuiltinNumber<Number>::write_a_literal_or_from_integer_or_from_float>
    explicit Fixed(Number) = delete;

    /// \cond internal
#define FIXEDPOINT_REFUSE(operation, First, Second, Refused)                                  \
    template <class Number>                                                                   \
    friend typename Refused<Number>::write_a_literal_or_from_integer_or_from_float operation( \
        First, Second) = delete;
#define FIXEDPOINT_REFUSE_MIXED(operation, RefusedBefore, RefusedBehind)  \
    FIXEDPOINT_REFUSE(operation, Number, Fixed, RefusedBefore)            \
    FIXEDPOINT_REFUSE(operation, Fixed, Number, RefusedBehind)            \
    template <int OtherInteger, int OtherFraction, class OtherArithmetic> \
    friend convert_one_operand_to_the_format_of_the_other operation(      \
        Fixed, Fixed<OtherInteger, OtherFraction, OtherArithmetic>) = delete;
    FIXEDPOINT_REFUSE_MIXED(operator+, NotBesideFixed, NotBesideFixed)
    FIXEDPOINT_REFUSE_MIXED(operator-, NotBesideFixed, NotBesideFixed)
    FIXEDPOINT_REFUSE_MIXED(operator*, NotBesideFixed, NotBesideFixed)
    FIXEDPOINT_REFUSE_MIXED(operator/, BuiltinNumber, NotBesideFixed)
    FIXEDPOINT_REFUSE_MIXED(operator%, BuiltinNumber, BuiltinNumber)
    FIXEDPOINT_REFUSE_MIXED(operator==, NotBesideFixed, NotBesideFixed)
    FIXEDPOINT_REFUSE_MIXED(operator!=, NotBesideFixed, NotBesideFixed)
    FIXEDPOINT_REFUSE_MIXED(operator<, NotBesideFixed, NotBesideFixed)
    FIXEDPOINT_REFUSE_MIXED(operator>, NotBesideFixed, NotBesideFixed)
    FIXEDPOINT_REFUSE_MIXED(operator<=, NotBesideFixed, NotBesideFixed)
    FIXEDPOINT_REFUSE_MIXED(operator>=, NotBesideFixed, NotBesideFixed)
#undef FIXEDPOINT_REFUSE_MIXED
#undef FIXEDPOINT_REFUSE

#define FIXEDPOINT_REFUSE_MIXED(operation, Refused)                                             \
    template <class Number>                                                                     \
    typename Refused<Number>::write_a_literal_or_from_integer_or_from_float operation(Number) = \
        delete;                                                                                 \
    template <int OtherInteger, int OtherFraction, class OtherArithmetic>                       \
    convert_one_operand_to_the_format_of_the_other operation(                                   \
        Fixed<OtherInteger, OtherFraction, OtherArithmetic>) = delete;
    FIXEDPOINT_REFUSE_MIXED(operator+=, NotBesideFixed)
    FIXEDPOINT_REFUSE_MIXED(operator-=, NotBesideFixed)
    FIXEDPOINT_REFUSE_MIXED(operator*=, NotBesideFixed)
    FIXEDPOINT_REFUSE_MIXED(operator/=, NotBesideFixed)
    FIXEDPOINT_REFUSE_MIXED(operator%=, BuiltinNumber)
#undef FIXEDPOINT_REFUSE_MIXED
    /// \endcond

  private:
    struct Private {};
    constexpr Fixed(Raw raw, Private) : raw_(raw) {}

    // Whether the integer is a number of the format.
    template <class Int>
    static constexpr bool holds(Int n) {
        return portable::integer_fits<Raw, FractionBits>(n);
    }

    // A count that an unsigned char cannot represent exceeds every width.
    template <class Count>
    static constexpr unsigned char shift_count(Count count) {
        static_assert(BuiltinNumber<Count>::is_integer, "A shift takes an integer count.");
        return static_cast<unsigned char>(
            static_cast<unsigned char>(count) == count ? static_cast<unsigned char>(count) : 255);
    }

    Raw raw_;
};

/// \cond internal
// Matches any stream of the C++ library, with lower priority than the operators of host/stream.hpp.
struct include_fixedpoint_host_stream_hpp {
    template <class Stream, class = decltype(static_cast<Stream*>(nullptr)->rdbuf())>
    include_fixedpoint_host_stream_hpp(Stream&);
};
template <int IntegerBits, int FractionBits, class Arithmetic>
void operator<<(include_fixedpoint_host_stream_hpp,
                Fixed<IntegerBits, FractionBits, Arithmetic>) = delete;
template <int IntegerBits, int FractionBits, class Arithmetic>
void operator>>(include_fixedpoint_host_stream_hpp,
                Fixed<IntegerBits, FractionBits, Arithmetic>&) = delete;
/// \endcond

// For each width, the format with as many integer bits as fraction bits, in the default arithmetic;
// and that of 24 bits with the fraction bits of Q16.16.

/// 8 bits: -8 to 7.9375 in steps of 0.0625.
using Q4_4 = Fixed<4, 4>;
/// 16 bits: -128 to 127.996 in steps of 0.0039.
using Q8_8 = Fixed<8, 8>;
/// 24 bits: -128 to 127.99998 in steps of 0.000015.
using Q8_16 = Fixed<8, 16>;
/// 24 bits: -2048 to 2047.9998 in steps of 0.00024.
using Q12_12 = Fixed<12, 12>;
/// 32 bits: -32768 to 32767.99998 in steps of 0.000015.
using Q16_16 = Fixed<16, 16>;
/// 64 bits: -2^31 to 2^31 in steps of 2.3e-10.
using Q32_32 = Fixed<32, 32>;

}  // namespace fixedpoint
