// SPDX-License-Identifier: GPL-3.0-or-later
// The published figures of the whole device, measured again.
#pragma once

#include "bench/experiments/haptic/haptic.hpp"

namespace haptic {

// The part of the run that haptic_pins.csv shows, in seconds: three frames.
inline constexpr double pins_from = 2, pins_to = 2.16;

// Writes workload_firmware.csv: what the device of the report, rebuilt, does beside what was
// published of it, and ours beside both, on the bare chip and as an Arduino sketch, each by the ELF
// that was measured; and haptic_pins.csv: when the profiling pins of the published device and of
// ours were high, step and rendering over three frames, the other pins within one step.
void write_workload(const Options& options);

}  // namespace haptic
