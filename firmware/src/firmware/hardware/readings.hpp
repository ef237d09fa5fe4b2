// SPDX-License-Identifier: MIT
/// \file
/// What the hardware layers share.
#pragma once

#include <stdint.h>

#include <fixedpoint/constexpr.hpp>

namespace firmware {

/// The inputs, in the order in which they are sampled.
enum Input : uint8_t { sensor_a, sensor_b, dial, inputs };

/// For each input, the sum of its newest Configuration::readings_in_sum readings, each in 0..1023
/// for 0 V to the supply's 5 V. Each input is sampled every 0.33 ms.
struct Readings {
    /// The sums, in the order of Input.
    uint16_t sum[inputs];
};

/// The clock counts half microseconds in 32 bits and wraps after 35 minutes and 47 seconds. Only
/// the difference of two times that are less than that apart has a meaning.
/// @{
constexpr uint32_t ticks_per_second = 2000000;
constexpr uint16_t ticks_per_millisecond = ticks_per_second / 1000;
constexpr uint8_t ticks_per_microsecond = ticks_per_millisecond / 1000;
/// @}

/// The pulse in ticks that a servo gets: the one requested, limited to the servo's travel.
template <class Configuration>
FIXEDPOINT_CONSTEXPR uint16_t servo_pulse(uint16_t ticks) {
    constexpr uint16_t shortest = Configuration::servo_shortest * ticks_per_microsecond;
    constexpr uint16_t longest = Configuration::servo_longest * ticks_per_microsecond;
    return ticks < shortest ? shortest : ticks > longest ? longest : ticks;
}

}  // namespace firmware
