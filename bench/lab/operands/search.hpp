// SPDX-License-Identifier: GPL-3.0-or-later
// Worst-case search: hill climbing with restarts over the bits of the operands, towards the maximum
// of any objective, such as |error| or cycles. The result is a lower bound of the maximum.
#pragma once

#include <cstdint>
#include <limits>
#include <random>
#include <vector>

#include "bench/lab/operands/boundary.hpp"
#include "bench/lab/operands/operand_class.hpp"

namespace operands {

struct Worst {
    std::vector<std::int64_t> operands;
    double value = -std::numeric_limits<double>::infinity();
};

// `objective(std::span<const std::int64_t>)` returns a double, -infinity for operands to avoid. The
// same seed and budget give the same result. `evaluations` is the number of calls of the objective.
//
// A climb starts at random operands, takes every mutation that is not worse, and ends when none of
// 24 mutations per bit of the operands was better. A third of the starts is of class physics, a
// third of class full, and a third mixes rows of the boundary table.
template <class Objective>
Worst search_worst(reference::Operation operation, const reference::NumberFormat& format,
                   std::uint64_t evaluations, std::uint64_t seed, Objective&& objective) {
    const std::size_t arity = reference::shape(operation).operands;
    const std::vector<BoundaryOperand> boundary = boundary_operands(format);
    const std::uint64_t patience = 24 * arity * std::uint64_t(format.width);
    Sampler physics(operation, format, OperandClass::physics, seed);
    Sampler full(operation, format, OperandClass::full, seed);
    std::mt19937_64 random(seed);
    const auto below = [&](std::size_t count) { return std::size_t(random() % count); };

    const auto start = [&](std::vector<std::int64_t>& operands) {
        switch (below(3)) {
            case 0:
                return physics.next(operands);
            case 1:
                return full.next(operands);
            default:
                full.next(operands);
                for (std::int64_t& operand : operands) {
                    if (below(2)) operand = boundary[below(boundary.size())].raw;
                }
        }
    };
    // Flips one or two bits, steps to a nearby raw, or shifts an operand by one bit.
    const auto mutate = [&](std::vector<std::int64_t>& operands) {
        std::int64_t& operand = operands[below(arity)];
        const auto flip = [&] { return std::uint64_t(1) << below(std::size_t(format.width)); };
        std::uint64_t pattern = std::uint64_t(operand);
        switch (below(5)) {
            case 0:
                pattern ^= flip();
                break;
            case 1:
                pattern ^= flip() ^ flip();
                break;
            case 2:
                pattern += 1 + below(16);
                break;
            case 3:
                pattern -= 1 + below(16);
                break;
            default:
                pattern = below(2) ? pattern << 1 : std::uint64_t(operand >> 1);
        }
        operand = format.extend(pattern);
    };

    Worst worst;
    worst.operands.resize(arity);
    std::vector<std::int64_t> climber(arity), candidate(arity);
    while (evaluations > 0) {
        start(climber);
        double height = objective(std::span<const std::int64_t>(climber));
        --evaluations;
        for (std::uint64_t idle = 0; idle < patience && evaluations > 0; ++idle, --evaluations) {
            candidate = climber;
            mutate(candidate);
            const double value = objective(std::span<const std::int64_t>(candidate));
            if (value < height) continue;
            if (value > height) idle = 0;
            height = value;
            climber = candidate;
        }
        if (height > worst.value) worst = {climber, height};
    }
    return worst;
}

}  // namespace operands
