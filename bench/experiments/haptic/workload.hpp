// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the published figures of the whole device again.
#pragma once

#include "bench/experiments/haptic/haptic.hpp"

namespace haptic {

// The part of the run that haptic_pins.csv shows, in seconds: three frames.
inline constexpr double pins_from = 2, pins_to = 2.16;

// Writes workload_firmware.csv: the rebuilt 2016 device next to its published figures, and our
// device next to both, on the bare chip and as an Arduino sketch, each identified by the ELF that
// was measured. Writes haptic_pins.csv: when the profiling pins of the published device and of ours
// were high, step and rendering over three frames, and the other pins within one step.
void write_workload(const Options& options);

}  // namespace haptic
