// SPDX-License-Identifier: MIT
// The definition of lines and circles, cell by cell and by inequalities only: no cell is derived
// from another one, and no coordinate is too large.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

namespace rasteriser {

struct Line {
    std::int64_t x0, y0, x1, y1;
};
struct Circle {
    std::int64_t x, y, radius;
};

// Whether (along, across) is the cell nearest to the line in its column; of two, the upper.
inline bool on_line_along(std::int64_t along, std::int64_t across, std::int64_t a0, std::int64_t b0,
                          std::int64_t a1, std::int64_t b1) {
    if (a1 < a0) return on_line_along(along, across, a1, b1, a0, b0);
    if (along < a0 || along > a1) return false;
    // across - 1/2 <= b0 + (along - a0) (b1 - b0) / (a1 - a0) < across + 1/2
    const std::int64_t width = a1 - a0;
    const std::int64_t twice = 2 * ((along - a0) * (b1 - b0) + (b0 - across) * width);
    return -width <= twice && twice < width;
}

inline bool covers(const Line& line, std::int64_t x, std::int64_t y) {
    const auto [x0, y0, x1, y1] = line;
    if (x0 == x1 && y0 == y1) return x == x0 && y == y0;
    return std::abs(y1 - y0) > std::abs(x1 - x0) ? on_line_along(y, x, y0, x0, y1, x1)
                                                 : on_line_along(x, y, x0, y0, x1, y1);
}

inline bool covers(const Circle& circle, std::int64_t x, std::int64_t y) {
    const std::int64_t r = circle.radius;
    const std::int64_t i = std::abs(x - circle.x), j = std::abs(y - circle.y);
    if (r <= 0) return r == 0 && i == 0 && j == 0;
    // greater - 1/2 < sqrt(r^2 - lesser^2) < greater + 1/2
    const std::int64_t greater = std::max(i, j), lesser = std::min(i, j);
    const std::int64_t square = 4 * (r * r - lesser * lesser);
    return (2 * greater - 1) * (2 * greater - 1) < square &&
           square < (2 * greater + 1) * (2 * greater + 1);
}

// The rows of a picture, from the top; each cell is a character.
using Picture = std::vector<std::string>;

template <class Shape>
void draw(Picture& picture, const Shape& shape, char character) {
    const int rows = static_cast<int>(picture.size());
    for (int y = 0; y < rows; ++y)
        for (int x = 0; x < static_cast<int>(picture[0].size()); ++x)
            if (covers(shape, x, y)) picture[rows - 1 - y][x] = character;
}

inline Picture blank(int columns, int rows) { return Picture(rows, std::string(columns, ' ')); }

}  // namespace rasteriser
