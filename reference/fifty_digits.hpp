// SPDX-License-Identifier: GPL-3.0-or-later
// FiftyDigits: a floating-point number of 50 decimal digits with the operators of a built-in one,
// no conversions but from integers and double, and no expression templates. What a computation in
// it has as error is the method's alone.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>

namespace reference {

class FiftyDigits {
  public:
    using Value = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                                boost::multiprecision::et_off>;

    FiftyDigits() = default;
    explicit FiftyDigits(long long n) : value_(n) {}
    explicit FiftyDigits(long n) : value_(n) {}
    explicit FiftyDigits(int n) : value_(n) {}
    explicit FiftyDigits(double x) : value_(x) {}
    explicit FiftyDigits(const Value& value) : value_(value) {}

    const Value& value() const { return value_; }
    explicit operator double() const { return static_cast<double>(value_); }

    friend FiftyDigits operator+(const FiftyDigits& a, const FiftyDigits& b) {
        return FiftyDigits(a.value_ + b.value_);
    }
    friend FiftyDigits operator-(const FiftyDigits& a, const FiftyDigits& b) {
        return FiftyDigits(a.value_ - b.value_);
    }
    friend FiftyDigits operator*(const FiftyDigits& a, const FiftyDigits& b) {
        return FiftyDigits(a.value_ * b.value_);
    }
    friend FiftyDigits operator/(const FiftyDigits& a, const FiftyDigits& b) {
        return FiftyDigits(a.value_ / b.value_);
    }
    FiftyDigits operator-() const { return FiftyDigits(Value(-value_)); }
    FiftyDigits& operator+=(const FiftyDigits& b) { return *this = *this + b; }
    FiftyDigits& operator-=(const FiftyDigits& b) { return *this = *this - b; }
    FiftyDigits& operator*=(const FiftyDigits& b) { return *this = *this * b; }
    FiftyDigits& operator/=(const FiftyDigits& b) { return *this = *this / b; }

    friend bool operator==(const FiftyDigits& a, const FiftyDigits& b) {
        return a.value_ == b.value_;
    }
    friend bool operator<(const FiftyDigits& a, const FiftyDigits& b) {
        return a.value_ < b.value_;
    }
    friend bool operator>(const FiftyDigits& a, const FiftyDigits& b) { return b < a; }
    friend bool operator<=(const FiftyDigits& a, const FiftyDigits& b) { return !(b < a); }
    friend bool operator>=(const FiftyDigits& a, const FiftyDigits& b) { return !(a < b); }

    friend FiftyDigits sqrt(const FiftyDigits& a) {
        return FiftyDigits(Value(boost::multiprecision::sqrt(a.value_)));
    }

  private:
    Value value_ = 0;
};

}  // namespace reference
