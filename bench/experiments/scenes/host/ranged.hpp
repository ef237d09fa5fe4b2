// SPDX-License-Identifier: GPL-3.0-or-later
// Ranged: a double that records the largest magnitude of all results, to find out which formats
// cannot hold them. Of dot products and lengths only the result counts, since the library's have no
// intermediate overflow.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <engine/scalar.hpp>

namespace scene_bench {

class Ranged {
  public:
    Ranged() = default;
    explicit Ranged(std::int64_t n) : value_(static_cast<double>(n)) {}
    explicit Ranged(int n) : value_(n) {}

    explicit operator double() const { return value_; }

    static Ranged result(double value) {
        largest() = std::max(largest(), std::abs(value));
        Ranged made;
        made.value_ = value;
        return made;
    }
    // Of this thread, until it is reset.
    static double& largest() {
        static thread_local double magnitude = 0;
        return magnitude;
    }

    friend Ranged operator+(Ranged a, Ranged b) { return result(a.value_ + b.value_); }
    friend Ranged operator-(Ranged a, Ranged b) { return result(a.value_ - b.value_); }
    friend Ranged operator*(Ranged a, Ranged b) { return result(a.value_ * b.value_); }
    friend Ranged operator/(Ranged a, Ranged b) { return result(a.value_ / b.value_); }
    Ranged operator-() const { return result(-value_); }
    Ranged& operator+=(Ranged b) { return *this = *this + b; }
    Ranged& operator-=(Ranged b) { return *this = *this - b; }
    Ranged& operator*=(Ranged b) { return *this = *this * b; }
    Ranged& operator/=(Ranged b) { return *this = *this / b; }
    friend bool operator==(Ranged a, Ranged b) { return a.value_ == b.value_; }
    friend bool operator<(Ranged a, Ranged b) { return a.value_ < b.value_; }
    friend bool operator>(Ranged a, Ranged b) { return a.value_ > b.value_; }
    friend bool operator<=(Ranged a, Ranged b) { return a.value_ <= b.value_; }
    friend bool operator>=(Ranged a, Ranged b) { return a.value_ >= b.value_; }
    friend Ranged sqrt(Ranged a) { return result(std::sqrt(a.value_)); }

  private:
    double value_ = 0;
};

// What the engine's vectors require of their scalar.
template <int N>
Ranged dot(const Ranged* a, const Ranged* b) {
    double sum = 0;
    for (int i = 0; i < N; ++i) sum += static_cast<double>(a[i]) * static_cast<double>(b[i]);
    return Ranged::result(sum);
}
template <int N>
Ranged length(const Ranged* v) {
    double sum = 0;
    for (int i = 0; i < N; ++i) sum += static_cast<double>(v[i]) * static_cast<double>(v[i]);
    return Ranged::result(std::sqrt(sum));
}

}  // namespace scene_bench

namespace engine {

template <>
struct MultiplyAdd<scene_bench::Ranged> {
    using Ranged = scene_bench::Ranged;
    static Ranged of(Ranged a, Ranged b, Ranged c) {
        return Ranged::result(static_cast<double>(a) * static_cast<double>(b) +
                              static_cast<double>(c));
    }
};

}  // namespace engine
