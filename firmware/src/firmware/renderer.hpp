// SPDX-License-Identifier: MIT
/// \file
/// Shows a grid on a terminal at the other end of the serial port, one row per call, and never
/// waits:
///
///     if (renderer.idle() && frames.due(Board::ticks())) {
///         Grid& grid = renderer.begin();  // blank
///         ... draw ...
///         renderer.finish();
///     }
///     renderer.transmit();  // in every pass of the loop
///
/// Row 0 is the terminal's line `rows`; the top row is its line 1.
#pragma once

#include <stdint.h>

#include <firmware/flash_text.hpp>
#include <firmware/grid.hpp>
#include <firmware/terminal.hpp>

namespace firmware {

/// How a frame is sent.
enum class Protocol : uint8_t {
    changes,  ///< only the cells that changed, each run after a cursor movement
    lines     ///< every frame from the top, after as many blank lines: as published
};

/// A screen: derive from it and hide the members that differ.
struct Screen {
    /// The number of columns, 1 to 99.
    static constexpr uint8_t columns = 20;
    /// The number of rows, 1 to 90.
    static constexpr uint8_t rows = 20;
    static constexpr uint8_t bits = 2;  ///< per cell; 2^bits colours
    /// Whether nearer cells hide those behind them, which takes a byte of RAM per cell.
    static constexpr bool depth = false;
    /// How a frame is sent.
    static constexpr Protocol protocol = Protocol::changes;

    /// The character of a colour. The blank is a space.
    static char character(uint8_t colour) { return FIRMWARE_TEXT(" .o#+x*@%&$=-:|^")[colour]; }
};

/// The grid that a screen shows.
template <class Screen>
using GridOf = Grid<Screen::columns, Screen::rows, Screen::bits, Screen::depth>;

/// \cond internal
template <class Board, class Screen, Protocol protocol>
class Transmission;

template <class Board, class Screen>
class Transmission<Board, Screen, Protocol::changes> {
  protected:
    // Marks each cell as shown when it is sent, and only then, so that a row can be left in the
    // middle when the port is full, and resumed.
    bool send_row(GridOf<Screen>& grid, uint8_t row) {
        const uint8_t* const wanted = grid.row(row);
        uint8_t* const shown = shown_[row];
        bool adjacent = false;
        uint8_t column = 0;
        for (uint8_t i = 0; i < Grid::row_bytes; ++i) {
            if (wanted[i] == shown[i]) {
                adjacent = false;
                column = static_cast<uint8_t>(column + Grid::cells_per_byte);
                continue;
            }
            for (uint8_t k = 0; k < Grid::cells_per_byte; ++k, ++column) {
                const uint8_t mask = Grid::mask(column);
                if (((wanted[i] ^ shown[i]) & mask) == 0) {
                    adjacent = false;
                    continue;
                }
                char piece[terminal::longest_move + 1];
                uint8_t length = 0;
                if (!adjacent) {
                    length = terminal::move(piece, static_cast<uint8_t>(Grid::rows - row),
                                            static_cast<uint8_t>(column + 1));
                }
                piece[length++] = Screen::character(grid.colour(column, row));
                if (Board::writable() < length) return false;
                Board::try_write(piece, length);
                shown[i] = static_cast<uint8_t>((shown[i] & ~mask) | (wanted[i] & mask));
                adjacent = true;
            }
        }
        return true;
    }

    // Clears the terminal if its content is not known.
    bool send_head() {
        if (known_) return true;
        if (Board::writable() < terminal::clear_length) return false;
        terminal::clear_screen<Board>();
        for (auto& row : shown_)
            for (uint8_t& cells : row) cells = 0;
        known_ = true;
        return true;
    }
    void begin_frame() {}
    void forget() { known_ = false; }

  private:
    using Grid = GridOf<Screen>;

    bool known_ = false;
    uint8_t shown_[Grid::rows][Grid::row_bytes] = {};
};

template <class Board, class Screen>
class Transmission<Board, Screen, Protocol::lines> {
  protected:
    bool send_row(GridOf<Screen>& grid, uint8_t row) {
        for (; column_ < Screen::columns; ++column_)
            if (!send(Screen::character(grid.colour(column_, row)))) return false;
        return end_line();
    }
    bool send_head() {
        for (; blank_lines_ < Screen::rows; ++blank_lines_)
            if (!end_line()) return false;
        return true;
    }
    void begin_frame() { blank_lines_ = 0; }
    void forget() {}

  private:
    static bool send(char character) { return Board::try_write(&character, 1) == 1; }
    bool end_line() {
        if (Board::writable() < 2) return false;
        send('\r');
        send('\n');
        column_ = 0;
        return true;
    }

    uint8_t column_ = 0, blank_lines_ = 0;  // sent
};
/// \endcond

/// Shows a Screen on the terminal of a Board.
template <class Board, class Screen>
class Renderer : Transmission<Board, Screen, Screen::protocol> {
    using Transmission = firmware::Transmission<Board, Screen, Screen::protocol>;

  public:
    /// The grid to draw on.
    using Grid = GridOf<Screen>;

    /// Whether the last frame has been sent completely.
    bool idle() const { return rows_left_ == 0; }

    /// A blank grid for the next frame. The renderer must be idle().
    Grid& begin() {
        grid_.clear();
        return grid_;
    }
    /// Ends the drawing: transmit() sends it from now on.
    void finish() {
        Transmission::begin_frame();
        rows_left_ = Grid::rows;
    }

    /// Sends the next frame completely: for a terminal that was just attached or is garbled.
    void refresh() { Transmission::forget(); }

    /// Sends a row, or as much of it as the port takes. Does nothing while more than half of the
    /// port's buffer is full, since each call has to find its place in the row again.
    void transmit() {
        if (!idle() && Board::writable() >= Board::Configuration::transmit_capacity / 2) send();
    }

  private:
    // A function of its own, so that a call that has nothing to send saves no registers.
    __attribute__((noinline)) void send() {
        if (!Transmission::send_head()) return;
        if (Transmission::send_row(grid_, static_cast<uint8_t>(rows_left_ - 1))) --rows_left_;
    }

    Grid grid_;
    uint8_t rows_left_ = 0;  // the top row is sent first
};

}  // namespace firmware
