// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/fifty_digits.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <new>
#include <type_traits>

namespace reference {

struct FiftyDigits::Access {
    using Value = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                                boost::multiprecision::et_off>;
    static_assert(sizeof(Value) <= sizeof(FiftyDigits::storage_) && alignof(Value) <= 16,
                  "The storage of FiftyDigits has to hold the number.");
    static_assert(std::is_trivially_destructible_v<Value>, "Nothing destroys the number.");

    static const Value& of(const FiftyDigits& x) {
        return *reinterpret_cast<const Value*>(x.storage_);
    }
    static void set(FiftyDigits& x, const Value& value) { new (x.storage_) Value(value); }
    static FiftyDigits make(const Value& value) {
        FiftyDigits made(0LL);
        set(made, value);
        return made;
    }
};

FiftyDigits::FiftyDigits(long long n) { Access::set(*this, Access::Value(n)); }
FiftyDigits::FiftyDigits(double x) { Access::set(*this, Access::Value(x)); }
FiftyDigits::FiftyDigits(const char* decimal) { Access::set(*this, Access::Value(decimal)); }
FiftyDigits::FiftyDigits(const FiftyDigits& other) { Access::set(*this, Access::of(other)); }
FiftyDigits& FiftyDigits::operator=(const FiftyDigits& other) {
    Access::set(*this, Access::of(other));
    return *this;
}

FiftyDigits::operator double() const { return static_cast<double>(Access::of(*this)); }

FiftyDigits operator+(const FiftyDigits& a, const FiftyDigits& b) {
    using Access = FiftyDigits::Access;
    return Access::make(Access::of(a) + Access::of(b));
}
FiftyDigits operator-(const FiftyDigits& a, const FiftyDigits& b) {
    using Access = FiftyDigits::Access;
    return Access::make(Access::of(a) - Access::of(b));
}
FiftyDigits operator*(const FiftyDigits& a, const FiftyDigits& b) {
    using Access = FiftyDigits::Access;
    return Access::make(Access::of(a) * Access::of(b));
}
FiftyDigits operator/(const FiftyDigits& a, const FiftyDigits& b) {
    using Access = FiftyDigits::Access;
    return Access::make(Access::of(a) / Access::of(b));
}
FiftyDigits FiftyDigits::operator-() const { return Access::make(-Access::of(*this)); }

bool operator==(const FiftyDigits& a, const FiftyDigits& b) {
    return FiftyDigits::Access::of(a) == FiftyDigits::Access::of(b);
}
bool operator<(const FiftyDigits& a, const FiftyDigits& b) {
    return FiftyDigits::Access::of(a) < FiftyDigits::Access::of(b);
}

FiftyDigits sqrt(const FiftyDigits& a) {
    using Access = FiftyDigits::Access;
    return Access::make(Access::Value(boost::multiprecision::sqrt(Access::of(a))));
}

}  // namespace reference
