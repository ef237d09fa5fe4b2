// SPDX-License-Identifier: MIT
/// \file
/// The hardware layer for tests: a clock that the test advances, readings that it sets, the bytes
/// that were written, the pulse that was commanded. It has the functions of Atmega328p. Each test
/// needs a type of its own, since everything is static.
#pragma once

#include <firmware/configuration.hpp>
#include <firmware/hardware/readings.hpp>
#include <string>

namespace firmware {

/// A board under the test's control, with the members of Atmega328p.
template <class Chosen>
class Host : CheckedConfiguration<Chosen> {
  public:
    /// The configuration.
    using Configuration = Chosen;

    /// The world, for the test to read and set.
    struct World {
        /// The clock, in half microseconds.
        uint32_t ticks = 0;
        uint16_t inputs[firmware::inputs] = {};  ///< one reading of each, 0 .. 1023
        /// The servo's pulse, in half microseconds.
        uint16_t pulse = Configuration::servo_at_start * ticks_per_microsecond;
        std::string transmitted;  ///< what the line has taken from the ring buffer
        std::string waiting;      ///< what the ring buffer holds
        std::string received;     ///< what read() is to return
        /// What lost() is to return.
        uint8_t lost = 0;
        uint8_t pins = 0;  ///< one bit per category

        /// The line takes everything that waits.
        void drain() {
            transmitted += waiting;
            waiting.clear();
        }
    };
    /// The one world.
    static World& world() {
        static World world;
        return world;
    }

    /// Resets the world.
    static void start() { world() = World(); }
    /// The world's clock.
    static uint32_t ticks() { return world().ticks; }
    /// The reading of each input, times readings_in_sum.
    static Readings readings() {
        Readings result;
        for (int i = 0; i < inputs; ++i)
            result.sum[i] = world().inputs[i] * Configuration::readings_in_sum;
        return result;
    }
    /// Sets the pulse, limited to the servo's travel.
    static void command_servo(uint16_t pulse) { world().pulse = servo_pulse<Configuration>(pulse); }
    /// The free space in the ring buffer.
    static uint8_t writable() {
        return static_cast<uint8_t>(Configuration::transmit_capacity - world().waiting.size());
    }
    /// Takes as many bytes as there is room for and returns their number.
    static uint8_t try_write(const char* text, uint8_t length) {
        const uint8_t taken = length < writable() ? length : writable();
        world().waiting.append(text, taken);
        return taken;
    }
    /// Removes and returns the oldest byte to be received, or returns -1 if there is none.
    static int16_t read() {
        if (world().received.empty()) return -1;
        const uint8_t byte = static_cast<uint8_t>(world().received.front());
        world().received.erase(0, 1);
        return byte;
    }
    /// The number of received bytes that were lost.
    static uint8_t lost() { return world().lost; }
    /// Raises the category's pin if it is profiled.
    template <Category category>
    static void raise() {
        if (contains(Configuration::profiled, category)) world().pins |= set_of(category);
    }
    /// Lowers the category's pin if it is profiled.
    template <Category category>
    static void lower() {
        if (contains(Configuration::profiled, category))
            world().pins &= static_cast<uint8_t>(~set_of(category));
    }
    /// Returns immediately.
    static void idle() {}
};

}  // namespace firmware
