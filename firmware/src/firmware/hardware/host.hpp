// SPDX-License-Identifier: MIT
/// \file
/// The hardware layer as tests see it: a clock that the test moves, readings that it sets, the
/// bytes that were written, the pulse that was commanded. Same functions as Atmega328p; one type a
/// test, since all is static there.
#pragma once

#include <firmware/configuration.hpp>
#include <firmware/hardware/readings.hpp>
#include <string>

namespace firmware {

/// A board of which all is the test's: what Atmega328p has, by the same names.
template <class Chosen>
class Host : CheckedConfiguration<Chosen> {
  public:
    /// What it is configured by.
    using Configuration = Chosen;

    /// The world, for the test to read and set.
    struct World {
        /// The clock, in half microseconds.
        uint32_t ticks = 0;
        uint16_t inputs[firmware::inputs] = {};  ///< a reading each, 0 .. 1023
        /// The servo's pulse, in half microseconds.
        uint16_t pulse = Configuration::servo_at_start * ticks_per_microsecond;
        std::string transmitted;  ///< what the ring buffer let go of
        std::string waiting;      ///< what it holds
        std::string received;     ///< what read() is to return
        /// What lost() is to return.
        uint8_t lost = 0;
        uint8_t pins = 0;  ///< a bit a category

        /// The line takes what waits.
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

    /// Makes the world as it is at first.
    static void start() { world() = World(); }
    /// The world's clock.
    static uint32_t ticks() { return world().ticks; }
    /// Of each input, readings_in_sum times its reading.
    static Readings readings() {
        Readings result;
        for (int i = 0; i < inputs; ++i)
            result.sum[i] = world().inputs[i] * Configuration::readings_in_sum;
        return result;
    }
    /// The pulse, held to the servo's travel.
    static void command_servo(uint16_t pulse) { world().pulse = servo_pulse<Configuration>(pulse); }
    /// The room that is left in the ring buffer.
    static uint8_t writable() {
        return static_cast<uint8_t>(Configuration::transmit_capacity - world().waiting.size());
    }
    /// Takes as many bytes as there is room for, and returns their number.
    static uint8_t try_write(const char* text, uint8_t length) {
        const uint8_t taken = length < writable() ? length : writable();
        world().waiting.append(text, taken);
        return taken;
    }
    /// The oldest byte to be received, -1 where there is none.
    static int16_t read() {
        if (world().received.empty()) return -1;
        const uint8_t byte = static_cast<uint8_t>(world().received.front());
        world().received.erase(0, 1);
        return byte;
    }
    /// Received bytes that were lost.
    static uint8_t lost() { return world().lost; }
    /// Raises the category's pin, where it is profiled.
    template <Category category>
    static void raise() {
        if (contains(Configuration::profiled, category)) world().pins |= set_of(category);
    }
    /// Lowers the category's pin, where it is profiled.
    template <Category category>
    static void lower() {
        if (contains(Configuration::profiled, category))
            world().pins &= static_cast<uint8_t>(~set_of(category));
    }
    /// Returns at once.
    static void idle() {}
};

}  // namespace firmware
