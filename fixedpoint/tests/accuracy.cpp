// SPDX-License-Identifier: MIT
#include "accuracy.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <sstream>

#include "this_build.hpp"

namespace {

std::string key(const Measured& measured, exact::Format format) {
    return std::string(measured.name) + " " + std::to_string(format.width) + " " +
           std::to_string(format.fraction);
}

std::string pinned(const std::string& key) {
    static const auto table = [] {
        std::map<std::string, std::string> lines;
        std::ifstream file(source_folder() / "fixedpoint/tests/accuracy.txt");
        for (std::string line; std::getline(file, line);) {
            const std::size_t figures = line.find(" : ");
            if (figures != std::string::npos)
                lines[line.substr(0, figures)] = line.substr(figures + 3);
        }
        return lines;
    }();
    const auto line = table.find(key);
    return line == table.end() ? "" : line->second;
}

class Operands {
  public:
    Operands(exact::Format format, const Measured& measured)
        : format_(format), function_(measured.function) {
        if (function_ == nullptr) {
            pairs();
        } else {
            numbers();
        }
    }
    const std::vector<std::array<int64_t, 2>>& all() const { return all_; }

  private:
    void add(int64_t a, int64_t b = 0) {
        const bool positive = function_ && (*function_ == exact::Function::log ||
                                            *function_ == exact::Function::reciprocal_sqrt);
        if (std::max(std::abs(a), std::abs(b)) > exact::largest(format_.width)) return;
        if (!positive || a > 0) all_.push_back({a, b});
    }
    int64_t uniform() { return static_cast<int64_t>(random_()) >> (64 - format_.width); }

    void numbers() {
        const int width = format_.width, F = format_.fraction;
        if (width <= 16) {
            for (int64_t a = exact::smallest(width); a <= exact::largest(width); ++a) add(a);
            return;
        }
        // Exact values for 64 bits cost a thousand times as much.
        const int samples = width == 64 ? 25 : 2000;
        for (int bit = 0; bit < width - 1; bit += width == 64 ? 5 : 1) {
            for (int64_t offset = -1; offset <= 1; ++offset) {
                add((int64_t(1) << bit) + offset);
                add(-(int64_t(1) << bit) - offset);
            }
        }
        for (int i = 0; i < samples; ++i) {
            add(uniform());
            add(uniform() >> random_() % width);
            // Operands for which e^a does not saturate: from -(F + 2) ln 2 to (W - F) ln 2.
            const double at = -(F + 2) + (width + 2) * std::ldexp(double(random_() >> 11), -53);
            add(static_cast<int64_t>(
                std::ldexp(std::clamp(at * M_LN2, -100.0, 100.0), std::min(F, width - 9))));
        }
        if (width == 32 && F == 16) limits_of_intervals();
    }

    // Tables of Q16.16 have up to 256 intervals of the leading bits, of the quarter turn, or of the
    // number itself: both sides of each limit, and the middle.
    void limits_of_intervals() {
        for (int exponent = 0; exponent < 31; ++exponent) {
            for (int64_t leading = 256; leading < 512; ++leading) {
                const int64_t start = (leading << exponent) >> 8,
                              step = (int64_t(1) << exponent) >> 9;
                for (const int64_t offset : {int64_t(-1), int64_t(0), step}) {
                    add(start + offset);
                    add(-start - offset);
                }
            }
        }
        for (int interval = -2048; interval <= 2048; ++interval) {
            const auto angle = static_cast<int64_t>(interval * (M_PI / 512) * 65536);
            for (int64_t offset = -1; offset <= 1; ++offset) add(angle + offset);
        }
        for (int i = 0; i < 20000; ++i) {
            add(static_cast<int64_t>(random_() % (25 << 16)) - (12 << 16));
            add(static_cast<int64_t>(random_() % (1 << 24)) - (1 << 23));
        }
    }

    void pairs() {
        const int width = format_.width;
        if (width == 8) {
            for (int y = -128; y < 128; ++y) {
                for (int x = -128; x < 128; ++x) add(y, x);
            }
            return;
        }
        const int samples = width == 64 ? 40 : 1500;
        const auto of_any_size = [&] { return uniform() >> random_() % width; };
        for (int i = 0; i < samples; ++i) {
            // In separate statements: the order in which arguments are evaluated depends on the
            // compiler.
            const int64_t x = uniform(), y = uniform();
            add(y, x);
            const int64_t smaller_x = of_any_size(), smaller_y = of_any_size();
            add(smaller_y, smaller_x);
        }
        const int64_t edges[] = {exact::smallest(width) + 1, -1, 0, 1, 2, exact::largest(width)};
        for (const int64_t y : edges) {
            for (const int64_t x : edges) {
                if (y != 0 || x != 0) add(y, x);
            }
        }
        const bool has_tables =
            (width == 32 && format_.fraction == 16) || (width == 16 && format_.fraction == 8);
        if (!has_tables) return;
        // Each interval of the reciprocal's table with each of the arc tangent's, on both sides of
        // the limit; one of the eight octants after the other.
        int octant = 0;
        for (int64_t row = 0; row < 256; row += 3) {
            const int64_t longer = (256 + row) << (width - 10);
            for (int64_t ratio = 0; ratio <= 256; ++ratio) {
                for (int64_t offset = -1; offset <= 1; ++offset) {
                    const int64_t shorter = longer * ratio / 256 + offset;
                    if (shorter < 0 || shorter > longer) continue;
                    ++octant;
                    const int64_t y = octant & 1 ? shorter : longer,
                                  x = octant & 1 ? longer : shorter;
                    add(octant & 2 ? -y : y, octant & 4 ? -x : x);
                }
            }
        }
    }

    exact::Format format_;
    const exact::Function* function_;
    std::mt19937_64 random_{20};
    std::vector<std::array<int64_t, 2>> all_;
};

}  // namespace

void expect_accuracy(const Measured& measured) {
    for (const Subject& subject : measured.subjects) {
        const std::string line = key(measured, subject.format);
        double largest = 0, sum = 0;
        const Operands operands(subject.format, measured);
        for (const auto& operand : operands.all()) {
            const int64_t result = subject.compute(operand.data());
            const double error =
                measured.function
                    ? exact::function_error(*measured.function, operand[0], result, subject.format)
                    : exact::atan2_error(operand[0], operand[1], result, subject.format);
            ASSERT_LE(error, measured.bound)
                << line << " of " << operand[0] << " " << operand[1] << " is " << result;
            largest = std::max(largest, error);
            sum += error;
        }
        const double mean = sum / static_cast<double>(operands.all().size());
        char figures[64];
        std::snprintf(figures, sizeof figures, "%.6f %.8f", largest, mean);
        double pinned_largest = -1, pinned_mean = -1;
        std::sscanf(pinned(line).c_str(), "%lf %lf", &pinned_largest, &pinned_mean);
        // One result off by an ulp moves the mean by more than 1e-6.
        EXPECT_TRUE(std::abs(largest - pinned_largest) < 2e-6 &&
                    std::abs(mean - pinned_mean) < 1e-7)
            << "measured: " << line << " : " << figures;
    }
}
