// SPDX-License-Identifier: MIT
/// \file
/// A grid of cells of 1, 2 or 4 bits, on which lines and circles are drawn. Cell (0, 0) is at the
/// lower left. Everything is clipped: coordinates must be within +-`farthest_cell`, radii at most
/// that, and no call takes longer than a walk across the grid.
///
/// The cells that are drawn are defined independently of the algorithm:
/// - line: in each column (in each row, if the line is steeper than 45 degrees) the cell that is
/// nearest to the exact line; of two that are equally near, the upper (right) one;
/// - circle: in each column that it crosses at 45 degrees or less, the two cells whose centres are
/// vertically nearest to the exact circle, and likewise in each row, horizontally.
#pragma once

#include <stdint.h>

#include <fixedpoint/kernel/dispatch.hpp>

namespace firmware {

/// The largest coordinate: sums of two coordinates fit 16 bits, products of two 32.
constexpr int16_t farthest_cell = 8191;

/// \cond internal
// The integers nearest to a straight line from `from` to `to` in `steps` steps; of two that are
// equally near, the greater: from + floor((2 k (to - from) + steps) / (2 steps)) for step k.
class Interpolation {
  public:
    // `steps` must be above 0. The iteration starts at step `first`.
    Interpolation(int16_t from, int16_t to, int16_t steps, int16_t first) : steps_(steps) {
        const int16_t rise = to - from;
        whole_ = floor_divide(rise, steps);
        rest_ = static_cast<int16_t>(rise - whole_ * steps);
        value_ = from;
        error_ = static_cast<uint16_t>(steps);
        if (first != 0) {
            const uint32_t doubled =
                uint32_t{2} * static_cast<uint16_t>(rest_) * static_cast<uint32_t>(first) +
                static_cast<uint32_t>(steps);
            const uint16_t twice = static_cast<uint16_t>(2 * steps);
            const uint16_t quotient = static_cast<uint16_t>(doubled / twice);
            value_ = static_cast<int16_t>(value_ + whole_ * first + quotient);
            error_ = static_cast<uint16_t>(doubled - static_cast<uint32_t>(quotient) * twice);
        }
    }
    int16_t value() const { return value_; }
    void advance() {
        value_ += whole_;
        error_ = static_cast<uint16_t>(error_ + 2 * rest_);
        if (error_ >= 2 * static_cast<uint16_t>(steps_)) {
            error_ = static_cast<uint16_t>(error_ - 2 * steps_);
            ++value_;
        }
    }

  private:
    static int16_t floor_divide(int16_t a, int16_t b) {
        return a >= 0 ? (a < b ? 0 : a / b) : (a >= -b ? -1 : -((b - 1 - a) / b));
    }

    int16_t steps_, whole_, rest_, value_;
    uint16_t error_;  // 0 .. 2 steps - 1
};

// The depth of each cell, if there is a depth buffer. A greater depth is nearer to the viewer.
template <uint16_t cells, bool kept>
class DepthBuffer {
  public:
    void clear() {
        for (uint16_t i = 0; i < cells; ++i) depth_[i] = -128;
    }
    // Whether a point at this depth is at least as near as what the cell shows. If so, the cell
    // takes its depth.
    bool in_front(uint16_t cell, int8_t depth) {
        if (depth < depth_[cell]) return false;
        depth_[cell] = depth;
        return true;
    }

  private:
    int8_t depth_[cells];
};
template <uint16_t cells>
class DepthBuffer<cells, false> {
  public:
    void clear() {}
    bool in_front(uint16_t, int8_t) { return true; }
};

template <bool kept>
class DepthInterpolation : public Interpolation {
  public:
    using Interpolation::Interpolation;
};
template <>
class DepthInterpolation<false> {
  public:
    DepthInterpolation(int16_t, int16_t, int16_t, int16_t) {}
    int8_t value() const { return 0; }
    void advance() {}
};
/// \endcond

/// A grid of cells of `bits_` bits, with a depth for each cell if `depth_` is true.
template <uint8_t columns_, uint8_t rows_, uint8_t bits_, bool depth_>
class Grid : DepthBuffer<uint16_t{rows_} * columns_, depth_> {
    using Nearest = DepthBuffer<uint16_t{rows_} * columns_, depth_>;

  public:
    /// The number of columns, 1 to 99.
    static constexpr uint8_t columns = columns_;
    /// The number of rows, 1 to 90.
    static constexpr uint8_t rows = rows_;
    /// The bits of a cell: 1, 2 or 4.
    static constexpr uint8_t bits = bits_;
    /// Whether nearer cells hide those behind them.
    static constexpr bool depth = depth_;
    /// The number of cells in a byte.
    static constexpr uint8_t cells_per_byte = 8 / bits;
    /// The number of bytes in a row.
    static constexpr uint8_t row_bytes = (columns + cells_per_byte - 1) / cells_per_byte;
    /// The number of colours. Colour 0 is the blank.
    static constexpr uint8_t colours = 1 << bits;

    static_assert(bits == 1 || bits == 2 || bits == 4,
                  "A cell has 1, 2 or 4 bits: 2, 4 or 16 colours, of which 0 is the blank.");
    static_assert(columns >= 1 && columns <= 99 && rows >= 1 && rows <= 90,
                  "A grid has 1 to 99 columns and 1 to 90 rows, as a terminal addresses them.");

    /// Makes all cells blank and infinitely far away.
    void clear() {
        for (uint8_t row = 0; row < rows; ++row)
            for (uint8_t i = 0; i < row_bytes; ++i) cells_[row][i] = 0;
        Nearest::clear();
    }

    /// The colour of a cell, which must be inside the grid.
    uint8_t colour(uint8_t column, uint8_t row) const {
        return cells_[row][column / cells_per_byte] >> shift(column) & (colours - 1);
    }
    /// The bytes of a row, which must be inside the grid. The first column is in the lowest bits.
    /// @{
    const uint8_t* row(uint8_t row) const { return cells_[row]; }
    uint8_t* row(uint8_t row) { return cells_[row]; }
    /// @}
    /// The mask of a column's bits in its byte.
    static constexpr uint8_t mask(uint8_t column) {
        return static_cast<uint8_t>((colours - 1) << shift(column));
    }

    /// Colours a cell, unless a nearer one is there. Does nothing outside the grid. A greater z is
    /// nearer.
    void point(int16_t x, int16_t y, uint8_t colour, int8_t z = 0) {
        if (static_cast<uint16_t>(x) >= columns || static_cast<uint16_t>(y) >= rows) return;
        const uint8_t column = static_cast<uint8_t>(x), row = static_cast<uint8_t>(y);
        if (!Nearest::in_front(static_cast<uint16_t>(row * columns + column), z)) return;
        uint8_t& cell = cells_[row][column / cells_per_byte];
        cell = static_cast<uint8_t>((cell & ~mask(column)) |
                                    static_cast<uint8_t>(colour << shift(column)));
    }

    /// Draws a line between two cells, as defined at the top of the file. z changes from z0 to z1
    /// along it.
    void line(int16_t x0, int16_t y0, int16_t x1, int16_t y1, uint8_t colour, int8_t z0 = 0,
              int8_t z1 = 0) {
        const int16_t width = x1 < x0 ? x0 - x1 : x1 - x0;
        const int16_t height = y1 < y0 ? y0 - y1 : y1 - y0;
        if (width == 0 && height == 0) {
            point(x0, y0, colour, z0 < z1 ? z1 : z0);
            return;
        }
        const bool steep = height > width;
        End from = steep ? End{y0, x0, z0} : End{x0, y0, z0};
        End to = steep ? End{y1, x1, z1} : End{x1, y1, z1};
        if (to.along < from.along) {
            const End first = to;
            to = from;
            from = first;
        }
        line_along(steep, from, to, colour);
    }

    /// Draws the outline of a circle: a point if the radius is 0, nothing if it is negative.
    void circle(int16_t x, int16_t y, int16_t radius, uint8_t colour, int8_t z = 0) {
        if (radius <= 0) {
            if (radius == 0) point(x, y, colour, z);
            return;
        }
        // The greatest i with 2 i^2 - i < r^2: up to it, the nearest cell i columns from the centre
        // is at least i rows away, so that the arcs of columns and those of rows meet. 46341 / 2^16
        // exceeds sqrt(1/2), and i is less than r sqrt(1/2) + 1/2.
        const int32_t square = static_cast<int32_t>(radius) * radius;
        int16_t reach = static_cast<int16_t>((static_cast<uint32_t>(radius) * 46341u >> 16) + 1);
        while (static_cast<int32_t>(2 * reach - 1) * reach >= square) --reach;
        arcs_along(false, x, y, square, reach, colour, z);
        arcs_along(true, y, x, square, reach, colour, z);
    }

  private:
    static constexpr uint8_t shift(uint8_t column) {
        return static_cast<uint8_t>(column % cells_per_byte * bits);
    }
    static constexpr uint8_t length(bool vertical) { return vertical ? rows : columns; }

    // An end of a line. `along` is the axis that is walked, vertical or horizontal.
    struct End {
        int16_t along, across;
        int8_t z;
    };

    void point_along(bool vertical, int16_t along, int16_t across, uint8_t colour, int8_t z) {
        const int16_t x = vertical ? across : along;
        const int16_t y = vertical ? along : across;
        point(x, y, colour, z);
    }

    void line_along(bool vertical, End from, End to, uint8_t colour) {
        if (to.along < 0 || from.along >= length(vertical)) return;
        const int16_t first = from.along < 0 ? -from.along : 0;
        const int16_t end = to.along < length(vertical) ? to.along : length(vertical) - 1;
        const int16_t steps = to.along - from.along;
        Interpolation across(from.across, to.across, steps, first);
        DepthInterpolation<depth> z(from.z, to.z, steps, first);
        for (int16_t along = from.along + first; along <= end; ++along) {
            point_along(vertical, along, across.value(), colour, static_cast<int8_t>(z.value()));
            across.advance();
            z.advance();
        }
    }

    // Draws the cells whose distance `i` from the centre along the axis is at most `reach`. Their
    // distance across it is the integer h nearest to sqrt(s), s = r^2 - i^2: the one with -h < s -
    // h^2 <= h. It changes by at most one from cell to cell, and the error s - h^2 stays within 3 h
    // + 2 even before h has been corrected, which fits 16 bits.
    void arcs_along(bool vertical, int16_t centre, int16_t centre_across, int32_t square,
                    int16_t reach, uint8_t colour, int8_t z) {
        if (centre + reach < 0 || centre - reach >= length(vertical)) return;
        const bool clipped = centre < reach;
        int16_t i = clipped ? -centre : -reach;
        const int32_t rest = square - static_cast<int32_t>(i) * i;
        // The root of `rest` is 2^-8 times that of 2^16 `rest`.
        int16_t h = static_cast<int16_t>(
            clipped ? fixedpoint::kernel::sqrt_small<int32_t, 16>(rest) >> 8 : reach);
        int16_t error = static_cast<int16_t>(rest - static_cast<int32_t>(h) * h);
        for (; i <= reach && centre + i < length(vertical); ++i) {
            for (; error > h; ++h) error = static_cast<int16_t>(error - (2 * h + 1));
            for (; error <= -h; --h) error = static_cast<int16_t>(error + (2 * h - 1));
            point_along(vertical, centre + i, centre_across + h, colour, z);
            point_along(vertical, centre + i, centre_across - h, colour, z);
            error = static_cast<int16_t>(error - (2 * i + 1));
        }
    }

    uint8_t cells_[rows][row_bytes] = {};
};

}  // namespace firmware
