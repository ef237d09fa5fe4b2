// SPDX-License-Identifier: GPL-3.0-or-later
// What is shown, as cells of text: the same for a terminal and for a recording.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace live {

enum class Ink : std::uint8_t { plain, dim, title, rod, weight, pivot, measure, warning };
constexpr int inks = 8;

// The colour of an ink: 0xrrggbb on a dark background, and in a terminal's 256 colours.
struct Colour {
    std::uint32_t rgb;
    int terminal;
};
constexpr std::array<Colour, inks> colours = {{{0xd0d0d0, 252},
                                               {0x767676, 243},
                                               {0xffffff, 231},
                                               {0x5fafd7, 74},
                                               {0xffaf00, 214},
                                               {0xd0d0d0, 252},
                                               {0x5faf87, 72},
                                               {0xff8700, 208}}};

struct Cell {
    wchar_t glyph = L' ';
    Ink ink = Ink::plain;
    bool operator==(const Cell&) const = default;
};

class Picture {
  public:
    static constexpr int columns = 80, rows = 24;

    const Cell& at(int row, int column) const { return cells_[row * columns + column]; }
    // Text beyond the right edge is cut off.
    void put(int row, int column, std::wstring_view text, Ink ink = Ink::plain);
    bool operator==(const Picture&) const = default;

  private:
    std::array<Cell, rows * columns> cells_;
};

// A bar of that many cells, filled between two fractions of its length, to an eighth of a cell at
// its right end. Fractions outside 0 to 1 are cut off.
std::wstring bar(int cells, double from, double to);

std::string utf8(wchar_t glyph);

}  // namespace live
