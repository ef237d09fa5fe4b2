// SPDX-License-Identifier: MIT
/// \file
/// What a program chooses at compile time. Derive from Configuration, hide the members that differ,
/// and pass the type to a Board (hardware/). A feature that is off costs nothing. A configuration
/// that cannot work does not compile.
#pragma once

#include <stdint.h>

namespace firmware {

/// The parts of a program that are profiled. Each has an output pin that is high while it runs: PD2
/// (step) to PD6 (operation).
enum class Category : uint8_t { step, render, collision, square_root, operation };
/// The subjects of debug text. Each has its own line on the terminal.
enum class Topic : uint8_t { loop, sensors, servo, physics };

/// A set of categories or of topics: set_of(Category::step, Category::render).
/// @{
constexpr uint8_t set_of() { return 0; }
template <class Member, class... Members>
constexpr uint8_t set_of(Member first, Members... others) {
    return static_cast<uint8_t>(1 << static_cast<uint8_t>(first) | set_of(others...));
}
/// @}
/// Whether a set contains the member.
template <class Member>
constexpr bool contains(uint8_t set, Member member) {
    return (set >> static_cast<uint8_t>(member) & 1) != 0;
}

/// All choices, with their defaults.
struct Configuration {
    /// Inputs of the analogue-to-digital converter, sampled in turn.
    /// @{
    static constexpr uint8_t sensor_a_input = 0;
    static constexpr uint8_t sensor_b_input = 1;
    static constexpr uint8_t dial_input = 2;
    /// @}
    /// The number of readings of each input that are summed.
    static constexpr uint8_t readings_in_sum = 2;

    /// The servo's pulse in microseconds: the ends of its travel, and the pulse until the first
    /// command.
    /// @{
    static constexpr uint16_t servo_shortest = 1000;
    static constexpr uint16_t servo_longest = 2000;
    static constexpr uint16_t servo_at_start = 1500;
    /// @}

    /// Ring buffers of the serial port, in bytes.
    /// @{
    static constexpr uint8_t transmit_capacity = 64;
    static constexpr uint8_t receive_capacity = 16;
    /// @}

    static constexpr uint8_t profiled = set_of();  ///< the set of categories that have a pin
    static constexpr uint8_t debugged = set_of();  ///< topics
};

/// Does not compile if a configuration cannot work; the compiler prints the reason.
template <class Chosen>
struct CheckedConfiguration {
    /// Whether n is a power of two.
    static constexpr bool power_of_two(unsigned n) { return n != 0 && (n & (n - 1)) == 0; }

    static_assert(Chosen::sensor_a_input < 8 && Chosen::sensor_b_input < 8 &&
                      Chosen::dial_input < 8,
                  "The ATmega328P has the analogue inputs 0 to 7.");
    static_assert(Chosen::sensor_a_input != Chosen::sensor_b_input &&
                      Chosen::sensor_b_input != Chosen::dial_input &&
                      Chosen::dial_input != Chosen::sensor_a_input,
                  "The two sensors and the dial need an analogue input each.");
    static_assert(
        power_of_two(Chosen::readings_in_sum) && Chosen::readings_in_sum <= 32,
        "readings_in_sum must be a power of two up to 32: the average is a shift, and the "
        "readings are kept in RAM.");
    static_assert(Chosen::servo_shortest < Chosen::servo_longest,
                  "servo_shortest must be less than servo_longest.");
    static_assert(Chosen::servo_shortest >= 400 && Chosen::servo_longest <= 2600,
                  "No hobby servo takes pulses outside 400 to 2600 microseconds.");
    static_assert(Chosen::servo_at_start >= Chosen::servo_shortest &&
                      Chosen::servo_at_start <= Chosen::servo_longest,
                  "servo_at_start must be from servo_shortest to servo_longest.");
    static_assert(
        power_of_two(Chosen::transmit_capacity) && Chosen::transmit_capacity >= 16 &&
            Chosen::transmit_capacity <= 128,
        "transmit_capacity must be a power of two from 16, the longest piece that is written "
        "at once, to 128.");
    static_assert(power_of_two(Chosen::receive_capacity) && Chosen::receive_capacity <= 128,
                  "receive_capacity must be a power of two up to 128.");
};

}  // namespace firmware
