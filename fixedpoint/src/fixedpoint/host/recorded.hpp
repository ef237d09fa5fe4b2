// SPDX-License-Identifier: MIT
/// \file
/// Recorded<double> and Recorded<Fixed<...>>: a wrapper that computes as the wrapped number does
/// and records the exact result of every operation, before rounding and wrapping, by its source
/// line. Run your own data through your own code with it, and recording() shows which format each
/// line needs:
///
///     filter<Recorded<double>>(...);
///     for (const auto& line : recording().lines)
///         line.second.overflows(16), line.second.underflows(16);   // of Q16.16
///
/// A dot product, a length and a multiply_add record only their result, since the library's do not
/// overflow in between. "Exact" means computed in double, to 53 bits. Each thread has its own
/// recording.
#pragma once

#include <cmath>
#include <cstdint>
#include <fixedpoint/conversion.hpp>
#include <fixedpoint/math.hpp>
#include <fixedpoint/watch.hpp>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace fixedpoint {

/// The values that a variable, or the operations of a source line, took.
class Range {
  public:
    /// Adds a value. A value that is not finite overflows every format.
    void add(double x) {
        ++count_;
        if (x < least_) least_ = x;
        if (x > greatest_) greatest_ = x;
        if (x == 0) return;
        const double magnitude = std::abs(x);
        if (magnitude < smallest_) smallest_ = magnitude;
        if (!(magnitude < std::numeric_limits<double>::infinity())) {
            ++exponents_[1024];
            return;
        }
        // The most negative number of a format is a power of two, and -1/2 ulp is rounded to 0, so
        // a negative power of two is counted with the smaller magnitudes.
        int exponent;
        const double mantissa = std::frexp(x, &exponent);
        ++exponents_[mantissa == -0.5 ? exponent - 2 : exponent - 1];
    }

    /// The number of values.
    std::uint64_t count() const { return count_; }
    /// The lowest and the highest value; infinity and -infinity if there were none.
    /// @{
    double least() const { return least_; }
    double greatest() const { return greatest_; }
    /// @}
    /// The smallest magnitude other than 0; infinite if all values were 0.
    double smallest() const { return smallest_; }

    /// The number of values outside [-2^(integer_bits-1), 2^(integer_bits-1)).
    std::uint64_t overflows(int integer_bits) const {
        std::uint64_t sum = 0;
        for (const auto& each : exponents_)
            if (each.first >= integer_bits - 1) sum += each.second;
        return sum;
    }
    /// The number of values other than 0 that would be rounded to 0.
    std::uint64_t underflows(int fraction_bits) const {
        std::uint64_t sum = 0;
        for (const auto& each : exponents_)
            if (each.first < -fraction_bits - 1) sum += each.second;
        return sum;
    }
    /// The smallest number of integer bits, including the sign, with which no value overflows.
    int integer_bits() const {
        return exponents_.empty() || exponents_.rbegin()->first < 0
                   ? 1
                   : exponents_.rbegin()->first + 2;
    }

  private:
    std::uint64_t count_ = 0;
    double least_ = std::numeric_limits<double>::infinity();
    double greatest_ = -std::numeric_limits<double>::infinity();
    double smallest_ = std::numeric_limits<double>::infinity();
    std::map<int, std::uint64_t> exponents_;  // by k, where 2^k <= |x| < 2^(k+1)
};

/// Everything that Recorded numbers have recorded.
struct Recording {
    /// By file and line.
    std::map<std::pair<std::string, int>, Range> lines;
    /// By the name passed to watch().
    std::map<std::string, Range> variables;
    /// How often each operation was executed: "add", "multiply", "sqrt", ...
    std::map<std::string, std::uint64_t> operations;
};

/// This thread's recording. Assign Recording() to start over.
inline Recording& recording() {
    static thread_local Recording one;
    return one;
}

/// A number that records; the comment at the top of this file says what.
template <class Value>
class Recorded {
    // The operand of an operation and the line of that operation. An operator cannot have default
    // arguments, but the conversion to its parameter type can.
    struct Operand {
        Recorded number;
        const char* file;
        int line;
        Operand(const Recorded& x, const char* in_file = __builtin_FILE(),
                int on_line = __builtin_LINE())
            : number(x), file(in_file), line(on_line) {}
    };

  public:
    /// The number 0.
    Recorded() : value_() {}
    /// Wraps a value, which is not recorded.
    explicit Recorded(Value value) : value_(value) {}

    /// The wrapped number.
    Value value() const { return value_; }
    /// The wrapped number as a double.
    explicit operator double() const { return to_double(value_); }

    /// The operations of the wrapped number; each is recorded.
    /// @{
    friend Recorded operator+(const Recorded& a, const Operand& b) {
        return recorded(b, "add", a.value_ + b.number.value_, double(a) + double(b.number));
    }
    friend Recorded operator-(const Recorded& a, const Operand& b) {
        return recorded(b, "subtract", a.value_ - b.number.value_, double(a) - double(b.number));
    }
    friend Recorded operator*(const Recorded& a, const Operand& b) {
        return recorded(b, "multiply", a.value_ * b.number.value_, double(a) * double(b.number));
    }
    friend Recorded operator/(const Recorded& a, const Operand& b) {
        return recorded(b, "divide", a.value_ / b.number.value_, double(a) / double(b.number));
    }
    friend Recorded operator-(const Operand& a) {
        return recorded(a, "negate", -a.number.value_, -double(a.number));
    }
    Recorded& operator+=(const Operand& b) { return *this = *this + b; }
    Recorded& operator-=(const Operand& b) { return *this = *this - b; }
    Recorded& operator*=(const Operand& b) { return *this = *this * b; }
    Recorded& operator/=(const Operand& b) { return *this = *this / b; }
    /// @}

    /// Compares the wrapped numbers.
    /// @{
    friend bool operator==(const Recorded& a, const Recorded& b) { return a.value_ == b.value_; }
    friend bool operator!=(const Recorded& a, const Recorded& b) { return a.value_ != b.value_; }
    friend bool operator<(const Recorded& a, const Recorded& b) { return a.value_ < b.value_; }
    friend bool operator>(const Recorded& a, const Recorded& b) { return a.value_ > b.value_; }
    friend bool operator<=(const Recorded& a, const Recorded& b) { return a.value_ <= b.value_; }
    friend bool operator>=(const Recorded& a, const Recorded& b) { return a.value_ >= b.value_; }
    /// @}

    /// \cond internal
#define FIXEDPOINT_RECORDED_FUNCTION(name)                                   \
    friend Recorded name(const Operand& a) {                                 \
        using std::name;                                                     \
        return recorded(a, #name, static_cast<Value>(name(a.number.value_)), \
                        name(double(a.number)));                             \
    }
    FIXEDPOINT_RECORDED_FUNCTION(sqrt)
    FIXEDPOINT_RECORDED_FUNCTION(sin)
    FIXEDPOINT_RECORDED_FUNCTION(cos)
    FIXEDPOINT_RECORDED_FUNCTION(atan)
    FIXEDPOINT_RECORDED_FUNCTION(exp)
    FIXEDPOINT_RECORDED_FUNCTION(log)
    FIXEDPOINT_RECORDED_FUNCTION(floor)
    FIXEDPOINT_RECORDED_FUNCTION(ceil)
    FIXEDPOINT_RECORDED_FUNCTION(trunc)
    FIXEDPOINT_RECORDED_FUNCTION(abs)
#define FIXEDPOINT_RECORDED_ELEMENTARY(name, Function) FIXEDPOINT_RECORDED_FUNCTION(name)
    FIXEDPOINT_ELEMENTARY_UNARY(FIXEDPOINT_RECORDED_ELEMENTARY)
#undef FIXEDPOINT_RECORDED_ELEMENTARY
#undef FIXEDPOINT_RECORDED_FUNCTION
#define FIXEDPOINT_RECORDED_FUNCTION(name)                                             \
    friend Recorded name(const Recorded& a, const Operand& b) {                        \
        using std::name;                                                               \
        return recorded(b, #name, static_cast<Value>(name(a.value_, b.number.value_)), \
                        name(double(a), double(b.number)));                            \
    }
    FIXEDPOINT_RECORDED_FUNCTION(atan2)
    FIXEDPOINT_RECORDED_FUNCTION(hypot)
    FIXEDPOINT_RECORDED_FUNCTION(pow)
#undef FIXEDPOINT_RECORDED_FUNCTION
    /// \endcond

    /// a b + c, of which only the result is recorded.
    friend Recorded multiply_add(const Recorded& a, const Recorded& b, const Operand& c) {
        return recorded(c, "multiply_add", fused(a.value_, b.value_, c.number.value_),
                        double(a) * double(b) + double(c.number));
    }
    /// The smaller, the larger, and a limited to two bounds, as for the wrapped numbers; not
    /// recorded.
    /// @{
    friend Recorded min(const Recorded& a, const Recorded& b) { return b < a ? b : a; }
    friend Recorded max(const Recorded& a, const Recorded& b) { return a < b ? b : a; }
    friend Recorded clamp(const Recorded& a, const Recorded& low, const Recorded& high) {
        return max(low, min(a, high));
    }
    /// @}

    /// Records an operation that is not one of these, by the line of the call.
    static Recorded of(const char* operation, Value value, double exact,
                       const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
        return recorded(Operand(Recorded(), file, line), operation, value, exact);
    }

  private:
    static Recorded recorded(const Operand& at, const char* operation, Value value, double exact) {
        Recording& all = recording();
        all.lines[{at.file, at.line}].add(exact);
        ++all.operations[operation];
        return Recorded(value);
    }
    template <class Number>
    static double to_double(Number x) {
        return static_cast<double>(x);
    }
    template <int IntegerBits, int F, class A>
    static double to_double(Fixed<IntegerBits, F, A> x) {
        return to_float<double>(x);
    }
    template <class Number>
    static Number fused(Number a, Number b, Number c) {
        return a * b + c;
    }
    template <int IntegerBits, int F, class A>
    static Fixed<IntegerBits, F, A> fused(Fixed<IntegerBits, F, A> a, Fixed<IntegerBits, F, A> b,
                                          Fixed<IntegerBits, F, A> c) {
        return fixedpoint::multiply_add(a, b, c);
    }

    Value value_;
};

/// \cond internal
template <class Value>
struct Watch<Recorded<Value>> {
    static const Recorded<Value>& of(const Recorded<Value>& x, const char* name) {
        recording().variables[name].add(double(x));
        return x;
    }
};
/// \endcond

}  // namespace fixedpoint
