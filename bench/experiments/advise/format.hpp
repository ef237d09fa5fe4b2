// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

namespace advise {

// A number format. A width of 0 means float.
struct Format {
    int integer_bits = 0, fraction_bits = 0;

    int width() const { return integer_bits + fraction_bits; }
    bool is_float() const { return width() == 0; }
    int bytes() const { return is_float() ? 4 : width() / 8; }
    std::string name() const {
        return is_float() ? "float" : fmt::format("q{}_{}", integer_bits, fraction_bits);
    }
    double value(std::int64_t pattern) const {
        return is_float() ? std::bit_cast<float>(static_cast<std::int32_t>(pattern))
                          : std::ldexp(static_cast<double>(pattern), -fraction_bits);
    }
    // The pattern of a number, rounded half up and saturated.
    std::int64_t pattern(double x) const {
        if (is_float()) return std::bit_cast<std::int32_t>(static_cast<float>(x));
        const double limit = std::ldexp(1.0, width() - 1);
        const double exact = std::ldexp(x, fraction_bits), below = std::floor(exact);
        const double raw = exact - below >= 0.5 ? below + 1 : below;  // a sum with 0.5 would round
        if (raw >= limit) return static_cast<std::int64_t>((std::uint64_t(1) << (width() - 1)) - 1);
        return static_cast<std::int64_t>(std::max(raw, -limit));
    }
};

}  // namespace advise
