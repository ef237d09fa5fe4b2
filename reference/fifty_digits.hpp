// SPDX-License-Identifier: GPL-3.0-or-later
// FiftyDigits: a floating-point number of 50 decimal digits with the operators of a built-in one.
// It converts only from integers and double, and has no expression templates. The error of a
// computation in it is the error of the method alone.
//
// The number itself, a type of Boost.Multiprecision, is hidden behind plain functions: inlined into
// every scene and method it took half of their compile time.
#pragma once

namespace reference {

class FiftyDigits {
  public:
    FiftyDigits() : FiftyDigits(0) {}
    explicit FiftyDigits(long long n);
    explicit FiftyDigits(long n) : FiftyDigits(static_cast<long long>(n)) {}
    explicit FiftyDigits(int n) : FiftyDigits(static_cast<long long>(n)) {}
    explicit FiftyDigits(double x);

    explicit FiftyDigits(const char* decimal);  // throws std::runtime_error for any other text
    FiftyDigits(const FiftyDigits& other);
    FiftyDigits& operator=(const FiftyDigits& other);

    explicit operator double() const;

    friend FiftyDigits operator+(const FiftyDigits& a, const FiftyDigits& b);
    friend FiftyDigits operator-(const FiftyDigits& a, const FiftyDigits& b);
    friend FiftyDigits operator*(const FiftyDigits& a, const FiftyDigits& b);
    friend FiftyDigits operator/(const FiftyDigits& a, const FiftyDigits& b);
    FiftyDigits operator-() const;
    FiftyDigits& operator+=(const FiftyDigits& b) { return *this = *this + b; }
    FiftyDigits& operator-=(const FiftyDigits& b) { return *this = *this - b; }
    FiftyDigits& operator*=(const FiftyDigits& b) { return *this = *this * b; }
    FiftyDigits& operator/=(const FiftyDigits& b) { return *this = *this / b; }

    friend bool operator==(const FiftyDigits& a, const FiftyDigits& b);
    friend bool operator<(const FiftyDigits& a, const FiftyDigits& b);
    friend bool operator>(const FiftyDigits& a, const FiftyDigits& b) { return b < a; }
    friend bool operator<=(const FiftyDigits& a, const FiftyDigits& b) { return !(b < a); }
    friend bool operator>=(const FiftyDigits& a, const FiftyDigits& b) { return !(a < b); }

    friend FiftyDigits sqrt(const FiftyDigits& a);

  private:
    struct Access;  // to the number in the storage
    alignas(16) unsigned char storage_[64];
};

}  // namespace reference
