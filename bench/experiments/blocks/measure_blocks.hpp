// SPDX-License-Identifier: GPL-3.0-or-later
// Each block of the library (fixedpoint/blocks/) on the simulated chip and on the host, fed with
// the same inputs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace blocks {

struct Measurement {
    std::string block, format;
    double cycles_mean;  // of a step, its inputs read from and its outputs written to RAM
    std::uint32_t cycles_max;
    std::uint32_t flash;            // bytes beside a program without the block
    double max_error, rms_error;    // of the chip's outputs, against the same block in double
    unsigned outputs, unlike_host;  // outputs, and how many of them the host has otherwise
};

// The block in each format, every one for as many steps.
std::vector<Measurement> measure(unsigned steps);

}  // namespace blocks
