// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers that are the same on every machine, unlike those of the standard library's
// distributions.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

namespace haptic {

class Random {
  public:
    explicit Random(std::uint64_t seed) : bits_(seed) {}

    // Uniform in (0, 1].
    double uniform() { return static_cast<double>((bits_() >> 11) + 1) * 0x1p-53; }
    // Log-uniform from 1 / factor to factor.
    double log_uniform(double factor) { return std::pow(factor, 2 * uniform() - 1); }
    // Normal with mean 0 and standard deviation 1 (Box and Muller 1958).
    double normal() {
        const double radius = std::sqrt(-2 * std::log(uniform()));
        return radius * std::cos(2 * std::numbers::pi * uniform());
    }

  private:
    std::mt19937_64 bits_;
};

}  // namespace haptic
