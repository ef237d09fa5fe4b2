// SPDX-License-Identifier: MIT
// Every cell that a grid draws, compared with the inequalities of rasteriser.hpp.
#include <gtest/gtest.h>

#include <firmware/projection.hpp>
#include <random>

#include "rasteriser.hpp"

namespace firmware {
namespace {

constexpr char characters[] = " .o#";

template <class Grid>
rasteriser::Picture picture_of(const Grid& grid) {
    rasteriser::Picture picture = rasteriser::blank(Grid::columns, Grid::rows);
    for (int y = 0; y < Grid::rows; ++y)
        for (int x = 0; x < Grid::columns; ++x)
            picture[Grid::rows - 1 - y][x] = characters[grid.colour(x, y)];
    return picture;
}

using Square = Grid<20, 20, 2, false>;
using Odd = Grid<13, 7, 4, false>;

// Coordinates of every size: near the grid, a few of its lengths away, and as far as allowed.
class Coordinates {
  public:
    int16_t operator()() {
        const int reach[] = {25, 25, 100, farthest_cell};
        const int limit = reach[random_() % 4];
        return std::uniform_int_distribution<int>(-limit, limit)(random_);
    }
    int16_t radius() { return std::abs((*this)()); }

  private:
    std::mt19937 random_{1};
};

template <class Grid>
void expect_lines() {
    Coordinates coordinate;
    for (int trial = 0; trial < 20000; ++trial) {
        Grid grid;
        const rasteriser::Line line = {coordinate(), coordinate(), coordinate(), coordinate()};
        grid.line(line.x0, line.y0, line.x1, line.y1, 1);
        auto expected = rasteriser::blank(Grid::columns, Grid::rows);
        draw(expected, line, characters[1]);
        ASSERT_EQ(picture_of(grid), expected)
            << line.x0 << ' ' << line.y0 << ' ' << line.x1 << ' ' << line.y1;
    }
}
TEST(Grid, Lines) {
    expect_lines<Square>();
    expect_lines<Odd>();
}

// Certainly through the grid, from ends that may be far away.
TEST(Grid, LinesThatCross) {
    Coordinates coordinate;
    int drawn = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const int16_t far = farthest_cell - 40;
        const int16_t dx = coordinate() % far, dy = coordinate() % far;
        const rasteriser::Line line = {10 - dx, 10 - dy, 10 + dx, 10 + dy};
        Square grid;
        grid.line(line.x0, line.y0, line.x1, line.y1, 1);
        auto expected = rasteriser::blank(20, 20);
        draw(expected, line, characters[1]);
        ASSERT_EQ(picture_of(grid), expected)
            << line.x0 << ' ' << line.y0 << ' ' << line.x1 << ' ' << line.y1;
        drawn += grid.colour(10, 10) == 1;
    }
    EXPECT_EQ(drawn, 20000);
}

TEST(Grid, CirclesOfEveryRadiusAcrossTheGrid) {
    for (int16_t radius = -1; radius <= farthest_cell; ++radius) {
        for (const auto& [x, y] : {std::pair(10, 10),
                                   {10 - radius, 10},
                                   {12 + radius, 7},
                                   {5, 19 - radius},
                                   {3, radius},
                                   {10 - radius * 5 / 7, 10 - radius * 5 / 7},
                                   {10 + radius * 5 / 7, 10 - radius * 5 / 7}}) {
            if (std::abs(x) > farthest_cell || std::abs(y) > farthest_cell) continue;
            const rasteriser::Circle circle = {x, y, radius};
            Square grid;
            grid.circle(x, y, radius, 2);
            auto expected = rasteriser::blank(20, 20);
            draw(expected, circle, characters[2]);
            ASSERT_EQ(picture_of(grid), expected) << x << ' ' << y << ' ' << radius;
        }
    }
}

TEST(Grid, CirclesAnywhere) {
    Coordinates coordinate;
    for (int trial = 0; trial < 20000; ++trial) {
        const rasteriser::Circle circle = {coordinate(), coordinate(), coordinate.radius()};
        Odd grid;
        grid.circle(circle.x, circle.y, circle.radius, 3);
        auto expected = rasteriser::blank(Odd::columns, Odd::rows);
        draw(expected, circle, characters[3]);
        ASSERT_EQ(picture_of(grid), expected)
            << circle.x << ' ' << circle.y << ' ' << circle.radius;
    }
}

TEST(Grid, LaterShapesCoverEarlierOnes) {
    Square grid;
    grid.point(3, 4, 3);
    grid.point(4, 4, 1);
    grid.point(3, 4, 2);
    EXPECT_EQ(grid.colour(3, 4), 2);
    EXPECT_EQ(grid.colour(4, 4), 1);
    EXPECT_EQ(grid.colour(2, 4), 0);
    grid.clear();
    EXPECT_EQ(picture_of(grid), rasteriser::blank(20, 20));
}

TEST(DepthBuffer, TheNearestIsShown) {
    Grid<20, 20, 2, true> grid;
    grid.clear();
    grid.line(0, 5, 19, 5, 1, -10, 9);  // comes nearer from left to right: z = x - 10
    grid.line(0, 5, 19, 5, 2, 0, 0);
    for (int x = 0; x < 20; ++x) EXPECT_EQ(grid.colour(x, 5), x - 10 <= 0 ? 2 : 1) << x;
    grid.clear();
    grid.point(5, 5, 2, -100);
    EXPECT_EQ(grid.colour(5, 5), 2);
}

// A clipped line has the depth of the whole line.
TEST(DepthBuffer, OfAClippedLine) {
    Grid<20, 20, 2, true> grid;
    grid.clear();
    grid.line(-100, 5, 100, 5, 1, -100, 100);
    grid.line(0, 5, 19, 5, 2, 8, 8);
    for (int x = 0; x < 20; ++x) EXPECT_EQ(grid.colour(x, 5), x <= 8 ? 2 : 1) << x;
}

template <class Number>
Number number(double x);
template <>
float number<float>(double x) {
    return static_cast<float>(x);
}
template <>
double number<double>(double x) {
    return x;
}
template <>
fixedpoint::Q16_16 number<fixedpoint::Q16_16>(double x) {
    return fixedpoint::from_float<fixedpoint::Q16_16>(x);
}
template <>
fixedpoint::Q8_8 number<fixedpoint::Q8_8>(double x) {
    return fixedpoint::from_float<fixedpoint::Q8_8>(x);
}

template <class Number, int cells>
struct ViewOf {
    using Scalar = Number;
    static constexpr uint16_t cells_per_unit = cells;
    static Scalar left() { return number<Scalar>(-0.25); }
    static Scalar bottom() { return number<Scalar>(0.5); }
    static Scalar slice() { return number<Scalar>(0.125); }
};

template <class Number>
class ProjectionTest : public testing::Test {};
using Numbers = testing::Types<float, double, fixedpoint::Q16_16>;
TYPED_TEST_SUITE(ProjectionTest, Numbers, );

TYPED_TEST(ProjectionTest, CellsAreTheFloor) {
    using View = Projection<Square, ViewOf<TypeParam, 50>>;
    EXPECT_EQ(View::column(number<TypeParam>(-0.25)), 0);
    EXPECT_EQ(View::column(number<TypeParam>(-0.251)), -1);
    EXPECT_EQ(View::column(number<TypeParam>(-0.2301)), 0);
    EXPECT_EQ(View::column(number<TypeParam>(-0.2299)), 1);
    EXPECT_EQ(View::row(number<TypeParam>(0.8999)), 19);
    EXPECT_EQ(View::length(number<TypeParam>(0.0099)), 0);
    EXPECT_EQ(View::length(number<TypeParam>(0.0101)), 1);
}

TYPED_TEST(ProjectionTest, FarAwayIsLimitedToTheReach) {
    using View = Projection<Square, ViewOf<TypeParam, 50>>;
    EXPECT_EQ(View::column(number<TypeParam>(1e30)), farthest_cell / 50 * 50);
    EXPECT_EQ(View::column(number<TypeParam>(-1e30)), -(farthest_cell / 50 * 50));
    EXPECT_EQ(View::length(number<TypeParam>(32767)), farthest_cell / 50 * 50);
}

TEST(Projection, NotANumberIsLimitedToo) {
    using View = Projection<Square, ViewOf<float, 50>>;
    EXPECT_EQ(View::column(__builtin_nanf("")), -(farthest_cell / 50 * 50));
}

TEST(Projection, NarrowScalarsCountTheCellsOfTheGrid) {
    using View = Projection<Square, ViewOf<fixedpoint::Q8_8, 1>>;
    EXPECT_EQ(View::column(number<fixedpoint::Q8_8>(19.5)), 19);
    EXPECT_EQ(View::column(fixedpoint::Q8_8::max()), 31);
    EXPECT_EQ(View::column(fixedpoint::Q8_8::min()), -31);
}

TYPED_TEST(ProjectionTest, ASliceThroughASphere) {
    using View = Projection<Square, ViewOf<TypeParam, 50>>;
    const auto n = [](double x) { return number<TypeParam>(x); };
    for (const auto& [height, radius] : {std::pair(0.0, 5), {0.06, 4}, {-0.08, 3}, {0.1, 0}}) {
        Square grid;
        View::sphere(grid, n(-0.0499), n(0.7001), n(0.125 + height), n(0.1), 1);
        auto expected = rasteriser::blank(20, 20);
        draw(expected, rasteriser::Circle{10, 10, radius}, '.');
        EXPECT_EQ(picture_of(grid), expected) << height;
    }
    Square grid;
    View::sphere(grid, n(-0.0499), n(0.7001), n(0.125 - 0.12), n(0.1), 1);
    EXPECT_EQ(picture_of(grid), rasteriser::blank(20, 20));
}

TYPED_TEST(ProjectionTest, ASphereInFrontOfALine) {
    using Deep = Grid<20, 20, 2, true>;
    using View = Projection<Deep, ViewOf<TypeParam, 50>>;
    const auto n = [](double x) { return number<TypeParam>(x); };
    for (const double line_height : {-0.1, 0.3}) {
        Deep grid;
        grid.clear();
        View::sphere(grid, n(-0.0499), n(0.7001), n(0.2), n(0.1), 1);
        View::line(grid, n(-0.24), n(0.7001), n(line_height), n(0.14), n(0.7001), n(line_height),
                   2);
        EXPECT_EQ(grid.colour(5, 10), line_height < 0.2 ? 1 : 2);
        EXPECT_EQ(grid.colour(6, 10), 2);
    }
}

}  // namespace
}  // namespace firmware
