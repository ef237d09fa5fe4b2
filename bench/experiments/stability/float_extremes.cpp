// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/float_extremes.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <random>
#include <utility>

#include "bench/chip/simulator/device_function.hpp"

namespace stability {
namespace {

using Limits = std::numeric_limits<float>;
using Pair = std::pair<float, float>;

// By magnitude; each is used with either sign.
const float extremes[] = {
    0,
    0x1p-149f,         // the smallest subnormal
    0x3p-149f,         // whose half is a tie
    0x1.5p-140f,       // in the middle of the subnormals
    0x0.fffffep-126f,  // the largest subnormal
    0x1p-126f,         // the smallest normal
    0x1.000002p-126f,
    0x1.8p-100f,
    0x1p-75f,  // whose square is a subnormal
    0x1p-63f,  // whose square is the smallest normal
    0x1.fffffep-1f,
    1,
    0x1.000002p0f,
    3,
    0x1p24f,  // from here on one ulp is 2
    0x1p63f,
    0x1.fffffep63f,   // whose square is just finite
    0x1p64f,          // whose square is not
    0x1.fffffep127f,  // the largest
    Limits::infinity(),
    Limits::quiet_NaN(),
};

// A function of the device that maps two floats to the bits of a result.
struct Operation {
    const char* name;
    unsigned operands;
    int bytes;  // of the result
    float (*host)(float a, float b);
};
const Operation operations[] = {
    {"add", 2, 4, [](float a, float b) { return a + b; }},
    {"subtract", 2, 4, [](float a, float b) { return a - b; }},
    {"multiply", 2, 4, [](float a, float b) { return a * b; }},
    {"divide", 2, 4, [](float a, float b) { return a / b; }},
    {"square_root", 1, 4, [](float a, float) { return std::sqrt(a); }},
    {"less", 2, 1, [](float a, float b) { return float(a < b); }},
    {"equal", 2, 1, [](float a, float b) { return float(a == b); }},
};

std::vector<Pair> pairs_of(const Operation& operation) {
    std::vector<float> values;
    for (const float value : extremes) {
        values.push_back(value);
        values.push_back(-value);
    }
    std::vector<Pair> pairs;
    for (const float a : values) {
        if (operation.operands == 1) pairs.emplace_back(a, 0.0f);
        for (const float b : values)
            if (operation.operands == 2) pairs.emplace_back(a, b);
    }
    // Any patterns, and similar magnitudes, whose sums cancel.
    std::mt19937 bits(1);
    for (int i = 0; i < 2000; ++i) {
        const std::uint32_t a = bits(), b = bits();
        pairs.emplace_back(std::bit_cast<float>(a), std::bit_cast<float>(b));
        pairs.emplace_back(std::bit_cast<float>(a), std::bit_cast<float>(a ^ (b & 0x80ffffff)));
    }
    if (operation.operands == 1)
        for (auto& [a, b] : pairs) b = 0;
    return pairs;
}

bool same(float a, float b) {
    return (std::isnan(a) && std::isnan(b)) ||
           std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

}  // namespace

std::string class_of(float a, float b, float result) {
    const auto either = [&](auto is) { return is(a) || is(b); };
    const auto subnormal = [](float x) { return std::fpclassify(x) == FP_SUBNORMAL; };
    if (either([](float x) { return std::isnan(x); })) return "nan operand";
    if (either([](float x) { return std::isinf(x); })) return "infinite operand";
    if (either(subnormal)) return "subnormal operand";
    if (std::isnan(result)) return "result is nan";
    if (std::isinf(result)) return "result is infinite";
    if (subnormal(result)) return "result is subnormal";
    return result == 0 ? "result is zero" : "normal";
}

std::vector<FloatRow> compare_floats() {
    simulator::Chip chip{simulator::Elf(float_program())};
    chip.run_until_function("main");
    std::vector<FloatRow> rows;
    for (const Operation& operation : operations) {
        const std::vector<int> sizes(operation.operands, 4);
        simulator::DeviceFunction function(chip, operation.name,
                                           {.result = operation.bytes, .operands = sizes});
        std::map<std::string, FloatRow> of_class;
        for (const auto& [a, b] : pairs_of(operation)) {
            const auto outcome = operation.operands == 1 ? function(a) : function(a, b);
            const float device =
                operation.bytes == 4 ? outcome.as<float>() : float(outcome.as<std::uint8_t>());
            const float host = operation.host(a, b);
            FloatRow& row = of_class[class_of(a, b, operation.bytes == 4 ? host : 1)];
            ++row.pairs;
            if (same(host, device) || ++row.differ > 1) continue;
            row.first_mismatch = fmt::format("{:a} {:a}", a, b);
            row.host = fmt::format("{:a}", host);
            row.device = fmt::format("{:a}", device);
        }
        for (auto& [name, row] : of_class) {
            row.operation = operation.name;
            row.operands = name;
            rows.push_back(row);
        }
    }
    return rows;
}

void measure_float_extremes(const std::filesystem::path& output) {
    records::table_of(compare_floats()).save(output / "float_extremes.csv");
}

}  // namespace stability
