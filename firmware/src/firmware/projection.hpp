// SPDX-License-Identifier: MIT
/// \file
/// From a world of scalars to the cells of a grid; beyond it there are only integers. A View says
/// which part of the world the grid shows:
///
///     struct View {
///         using Scalar = Q16_16;
///         static constexpr uint16_t cells_per_unit = 50;                       // 2 cm a cell
///         static constexpr Scalar left() { ... } static constexpr Scalar bottom() { ... }
///         static constexpr Scalar slice() { ... }                              // z of the slice
///     };
///
/// Any coordinate is allowed: one that is farther than `reach` from the view's corner is drawn as
/// if it were exactly that far, in each axis separately. Nothing overflows.
#pragma once

#include <stdint.h>

#include <firmware/grid.hpp>
#include <fixedpoint/conversion.hpp>
#include <fixedpoint/kernel/dispatch.hpp>

namespace firmware {

/// \cond internal
// What the projection requires of a scalar: an integer as a scalar, the floor and the nearest
// integer of a number that fits, and the number of cells that it can count with room to spare.
template <class Float>
struct CellArithmetic {
    static constexpr int16_t max_cells = farthest_cell;
    static constexpr Float from_integer(int16_t n) { return n; }
    static int16_t floor(Float x) {
        const int16_t truncated = static_cast<int16_t>(x);
        return truncated > x ? truncated - 1 : truncated;
    }
    static int16_t nearest(Float x) { return floor(x + Float(0.5)); }
};
template <int I, int F, class A>
struct CellArithmetic<fixedpoint::Fixed<I, F, A>> {
    using Scalar = fixedpoint::Fixed<I, F, A>;
    static constexpr int16_t max_cells = I >= 16 ? farthest_cell : (1 << I >> 3) - 1;
    static constexpr Scalar from_integer(int16_t n) { return Scalar::from_integer(n); }
    static constexpr int16_t floor(Scalar x) { return static_cast<int16_t>(x.raw() >> F); }
    static constexpr int16_t nearest(Scalar x) { return fixedpoint::convert<int16_t>(x); }
};
/// \endcond

/// The cells of a Grid on which a View is shown.
template <class Grid, class View>
class Projection {
  public:
    /// The number type of the world.
    using Scalar = typename View::Scalar;

    /// The column of an x coordinate.
    static int16_t column(Scalar x) { return Cells::floor(scaled(x, View::left())); }
    /// The row of a y coordinate.
    static int16_t row(Scalar y) { return Cells::floor(scaled(y, View::bottom())); }
    /// A length in cells, rounded to nearest.
    static int16_t length(Scalar length) {
        return Cells::nearest(scaled(length, Cells::from_integer(0)));
    }

    /// Draws a circle's outline.
    static void circle(Grid& grid, Scalar x, Scalar y, Scalar radius, uint8_t colour) {
        grid.circle(column(x), row(y), length(radius), colour);
    }
    /// Draws a line between two points.
    static void line(Grid& grid, Scalar x0, Scalar y0, Scalar x1, Scalar y1, uint8_t colour) {
        grid.line(column(x0), row(y0), column(x1), row(y1), colour);
    }

    /// Draws a sphere. Without a depth buffer, draws the circle that the slice cuts out of the
    /// sphere, if it does. With one, draws the outline of the whole sphere, hidden by whatever is
    /// in front of its centre.
    static void sphere(Grid& grid, Scalar x, Scalar y, Scalar z, Scalar radius, uint8_t colour) {
        const int16_t height = Cells::nearest(scaled(z, View::slice()));
        int16_t cells = length(radius);
        if (!Grid::depth && height != 0) {
            const int32_t square = static_cast<int32_t>(cells) * cells;
            const int32_t cut = square - static_cast<int32_t>(height) * height;
            if (cut < 0) return;
            cells = (fixedpoint::kernel::sqrt_small<int32_t, 16>(cut) + 128) >> 8;
        }
        grid.circle(column(x), row(y), cells, colour, depth_of(height));
    }
    /// Draws a line in space with the depths of its ends. Without a depth buffer it is drawn at any
    /// depth.
    static void line(Grid& grid, Scalar x0, Scalar y0, Scalar z0, Scalar x1, Scalar y1, Scalar z1,
                     uint8_t colour) {
        const int16_t from = Cells::nearest(scaled(z0, View::slice()));
        const int16_t to = Cells::nearest(scaled(z1, View::slice()));
        grid.line(column(x0), row(y0), column(x1), row(y1), colour, depth_of(from), depth_of(to));
    }

  private:
    using Cells = CellArithmetic<Scalar>;
    static constexpr int16_t reach = Cells::max_cells / int16_t{View::cells_per_unit};  // units
    static_assert(reach * int32_t{View::cells_per_unit} >= Grid::columns &&
                      reach * int32_t{View::cells_per_unit} >= Grid::rows,
                  "The view's scalar is too narrow to count the cells of the grid at this scale.");

    static int8_t depth_of(int16_t cells) {
        return cells < -127 ? -127 : cells > 127 ? 127 : static_cast<int8_t>(cells);
    }

    // (coordinate - origin) in cells. NaN counts as the lower end.
    static Scalar scaled(Scalar coordinate, Scalar origin) {
        const Scalar low = origin - Cells::from_integer(reach);
        const Scalar high = origin + Cells::from_integer(reach);
        if (coordinate > high) coordinate = high;
        if (!(coordinate > low)) coordinate = low;
        return (coordinate - origin) * Cells::from_integer(View::cells_per_unit);
    }
};

}  // namespace firmware
