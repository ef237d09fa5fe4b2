// SPDX-License-Identifier: GPL-3.0-or-later
// The device's float compared with the host's, which follows IEEE 754: each operation of the engine
// on every pair of a table of extreme values, and on pairs drawn from a seed. Zeros of different
// signs differ, NaNs do not.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "bench/lab/records/record.hpp"
#include "this_build.hpp"

namespace stability {

// A row of float_extremes.csv: an operation on operands of a class. The first pair whose results
// differ, and both results, are in hexadecimal floating point; empty if none differ.
struct FloatRow {
    std::string operation, operands;
    unsigned pairs = 0, differ = 0;
    std::string first_mismatch, host, device;

    static constexpr auto columns = std::tuple(
        records::column("operation", &FloatRow::operation),
        records::column("operands", &FloatRow::operands),
        records::column("pairs", &FloatRow::pairs), records::column("differ", &FloatRow::differ),
        records::column("first_mismatch", &FloatRow::first_mismatch),
        records::column("host", &FloatRow::host), records::column("device", &FloatRow::device));
};

// The class of a pair and its result: the first that applies of nan operand, infinite operand,
// subnormal operand, result is nan, result is infinite, result is subnormal, result is zero,
// normal. The results of comparisons do not belong to a class.
std::string class_of(float a, float b, float result);

// Of the chip: device/float_operations.cpp.
inline std::filesystem::path float_program() {
    return build_folder() / "bench/experiments/stability/float_operations.elf";
}

// By that program.
std::vector<FloatRow> compare_floats();

// Writes float_extremes.csv.
void measure_float_extremes(const std::filesystem::path& output);

}  // namespace stability
