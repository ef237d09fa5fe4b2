// SPDX-License-Identifier: MIT
/// \file
/// Debug text by topic. A topic that the board's configuration does not list in `debugged` compiles
/// to nothing, including its strings. Strings stay in flash: FIRMWARE_TEXT("...").
///
/// Each topic has its own line below the renderer's grid, which its newest text replaces. A text
/// for which the serial port has no room is dropped and counted: nothing here waits.
#pragma once

#include <firmware/configuration.hpp>
#include <firmware/flash_text.hpp>
#include <firmware/terminal.hpp>
#include <fixedpoint/text.hpp>

namespace firmware {

/// Debug text of a Board. `first_line` is the terminal line of the first topic.
template <class Board, uint8_t first_line>
class Debug {
  public:
    /// Prints the text, followed by the number with that many decimals.
    template <Topic topic, class Number>
    static void print(FlashText text, Number number, uint8_t decimals) {
        if (!on(topic)) return;
        char digits[fixedpoint::text_capacity<Number>()];
        const uint8_t length =
            static_cast<uint8_t>(fixedpoint::print(number, decimals, digits, sizeof digits));
        write(line_of(topic), text, digits, length);
    }
    /// Prints the text, followed by an integer.
    template <Topic topic>
    static void print(FlashText text, int32_t number) {
        if (!on(topic)) return;
        print<topic>(text, fixedpoint::Fixed<32, 0>::from_raw(number), 0);
    }
    /// Prints the text alone.
    template <Topic topic>
    static void print(FlashText text) {
        if (!on(topic)) return;
        write(line_of(topic), text, nullptr, 0);
    }

    /// The number of texts dropped since the start; stops at 255.
    static uint8_t dropped() { return dropped_; }

  private:
    static constexpr bool on(Topic topic) {
        return contains(Board::Configuration::debugged, topic);
    }
    static constexpr uint8_t line_of(Topic topic) {
        return static_cast<uint8_t>(first_line + static_cast<uint8_t>(topic));
    }

    static void write(uint8_t line, FlashText text, const char* digits, uint8_t length) {
        char place[terminal::longest_move];
        const uint8_t moved = terminal::move(place, line, 1);
        // Together at most 255 bytes: more would not fit the largest ring buffer either.
        const uint16_t needed =
            static_cast<uint16_t>(moved + text.length + length + terminal::erase_length);
        if (needed > Board::writable()) {
            if (dropped_ != 255) ++dropped_;
            return;
        }
        Board::try_write(place, moved);
        terminal::write<Board>(text);
        if (length != 0) Board::try_write(digits, length);
        terminal::erase_rest_of_line<Board>();
    }

    static uint8_t dropped_;
};

template <class Board, uint8_t first_line>
uint8_t Debug<Board, first_line>::dropped_;

}  // namespace firmware
