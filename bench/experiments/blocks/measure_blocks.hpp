// SPDX-License-Identifier: GPL-3.0-or-later
// Each block of the library (fixedpoint/blocks/) on the simulated chip and on the host, with the
// same inputs.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace blocks {

struct Measurement {
    std::string block, format;
    double cycles_mean;  // per step, including reading inputs from RAM and writing outputs
    std::uint32_t cycles_max;
    std::uint32_t flash;            // bytes more than a program without the block
    double max_error, rms_error;    // of the chip's outputs, compared with double
    unsigned outputs, unlike_host;  // outputs, and how many differ from the host's
};

// Measures the block in each format, for the same number of steps.
std::vector<Measurement> measure(unsigned steps);

}  // namespace blocks
