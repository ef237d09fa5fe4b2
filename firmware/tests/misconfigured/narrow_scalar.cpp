// SPDX-License-Identifier: MIT
// The view's scalar is too narrow to count the cells of the grid at this scale.
#include <firmware/projection.hpp>

struct View {
    using Scalar = fixedpoint::Q8_8;
    static constexpr uint16_t cells_per_unit = 50;
    static constexpr Scalar left() { return Scalar(); }
    static constexpr Scalar bottom() { return Scalar(); }
    static constexpr Scalar slice() { return Scalar(); }
};
template class firmware::Projection<firmware::Grid<20, 20, 2, false>, View>;
