// SPDX-License-Identifier: GPL-3.0-or-later
// The published figures of the whole device, measured again.
#pragma once

#include "bench/haptic/haptic.hpp"

namespace haptic {

// Writes workload_firmware.csv: what the device of the report, rebuilt, does beside what was
// published of it, and ours beside both, each by the ELF that was measured.
void write_workload(const Options& options);

// Writes haptic_pins.csv: when the profiling pins of the published device and of ours were high,
// step and rendering over three frames, products and roots within one step.
void write_pins(const Options& options);

}  // namespace haptic
