// SPDX-License-Identifier: GPL-3.0-or-later
// The published timing harness on the simulated chip: one program (device/harness.cpp, compiled for
// one hypothesis) whose cells are timed, either in cycles for one pass of the loop or in
// milliseconds for all 30000, as counted by the Arduino core's millis().
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "bench/chip/simulator/chip.hpp"

namespace table_3_2 {

// The two operands as written in the source of the harness: `integer` in the integer types, `real`
// in float and the fixed-point types, or if `raw` the integers as raw values of the fixed-point
// types.
struct Operands {
    struct Pair {
        double a, b;
    };
    Pair integer;
    Pair real;
    bool raw;

    std::string name() const;
};

// A row and a column of the published table: "int16_t", "subtract".
struct Cell {
    std::string type;
    std::string operation;
    auto operator<=>(const Cell&) const = default;
};

class Harness {
  public:
    static constexpr int iterations = 30000;

    explicit Harness(const std::filesystem::path& program);

    // Mean cycles of one pass of the loop, interrupts off, over the given number of passes.
    // The form is "assign", "accumulate" or "replace".
    double cycles(const std::string& form, const Cell& cell, const Operands& operands, int passes);

    // The result of the whole loop as the sketch would print it: millis() after less millis()
    // before.
    std::uint32_t milliseconds(const std::string& form, const Cell& cell, const Operands& operands);

  private:
    const simulator::Symbol& prepare(const std::string& form, const Cell& cell,
                                     const Operands& operands);
    bool reaches(std::uint32_t address);
    void write(const std::string& object, std::uint64_t bits, int bytes);

    simulator::Chip chip_;
};

// The cycles of a pass as milliseconds for 30000 passes, without the timer's interrupt.
double undisturbed_ms(double cycles);

}  // namespace table_3_2
