// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/lab/operands/boundary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "bench/lab/operands/operand_class.hpp"

namespace operands {
namespace {

using reference::NumberFormat;
using reference::Operation;

__extension__ using Integer = __int128;  // holds 2^(2 F)

// The first description of a raw is kept.
using Table = std::map<std::int64_t, std::string>;

// floor(sqrt(square)), by bisection.
Integer root_of(Integer square) {
    Integer low = 0, high = Integer(1) << 63;
    while (high - low > 1) {
        const Integer middle = (low + high) / 2;
        (middle * middle <= square ? low : high) = middle;
    }
    return low;
}

// Numbers that the format does not hold are left out.
class FixedTable {
  public:
    explicit FixedTable(const NumberFormat& format) : format_(format), F_(format.fraction) {
        ends_and_zero();
        around("1", Integer(1) << F_);
        around("-1", -(Integer(1) << F_));
        if (F_ > 0) {
            around("0.5", Integer(1) << (F_ - 1));
            around("-0.5", -(Integer(1) << (F_ - 1)));
        }
        angles();
        function_borders();
        patterns();
        for (int bit = 0; bit < format.width - (format.is_unsigned ? 0 : 1); ++bit) {
            around(fmt::format("2^{}", bit - F_), Integer(1) << bit);
            around(fmt::format("-2^{}", bit - F_), -(Integer(1) << bit));
        }
    }

    Table take() { return std::move(table_); }

  private:
    void add(const std::string& what, const Integer& raw) {
        if (raw >= format_.min() && raw <= format_.max()) table_.emplace(std::int64_t(raw), what);
    }

    void around(const std::string& what, const Integer& raw) {
        add(what, raw);
        add(what + " - ulp", raw - 1);
        add(what + " + ulp", raw + 1);
    }

    void ends_and_zero() {
        add("0", 0);
        add("1 ulp, the smallest positive number", 1);
        add("-1 ulp, all bits set", -1);
        add("MAX", format_.max());
        add("MAX - ulp", Integer(format_.max()) - 1);
        add("MIN, whose negative does not fit", format_.min());
        add("MIN + ulp, the negative of MAX", Integer(format_.min()) + 1);
    }

    void rounded(const std::string& what, long double number) {
        if (std::abs(number) < std::ldexp(1.0L, format_.width - 1 - F_))
            around(what, Integer(std::floor(std::ldexp(number, F_) + 0.5L)));
    }

    // Where octants meet, and where a sine is extreme or zero.
    void angles() {
        for (const int k : {1, 2, 3, 4, 5, 6, 7, 8, 16, 400}) {
            rounded(fmt::format("{} pi/4, rounded", k), k * std::numbers::pi_v<long double> / 4);
            rounded(fmt::format("-{} pi/4, rounded", k), -k * std::numbers::pi_v<long double> / 4);
        }
    }

    void function_borders() {
        const Integer max = format_.max();
        const Integer root = root_of((max << F_) + (Integer(1) << F_) - 1);
        around("the largest number whose square fits", root);
        around("the smallest number whose square fits", -root);
        around("the largest number whose three equal squares sum up to one that fits",
               root_of(((max << F_) + (Integer(1) << F_) - 1) / 3));
        const Integer reciprocal = ((Integer(1) << (2 * F_)) + max - 1) / max;
        around("the smallest number whose reciprocal fits", reciprocal);
        around("the negative of the smallest number whose reciprocal fits", -reciprocal);
        rounded("ln MAX, the border of exp",
                std::log(std::ldexp((long double)(format_.max()), -F_)));
        rounded("ln of half an ulp, below which exp is 0",
                -(F_ + 1) * std::numbers::ln2_v<long double>);
    }

    // Bytes and bits at which carries propagate or tables begin and end.
    void patterns() {
        for (const std::uint64_t pattern :
             {0x5555555555555555u, 0xaaaaaaaaaaaaaaaau, 0x00ff00ff00ff00ffu, 0xff00ff00ff00ff00u,
              0x7f7f7f7f7f7f7f7fu, 0x8080808080808080u}) {
            const std::int64_t raw = format_.extend(pattern);
            const std::uint64_t bits =
                std::uint64_t(raw) << (64 - format_.width) >> (64 - format_.width);
            add(fmt::format("the pattern 0x{:0{}x}", bits, format_.width / 4), raw);
        }
    }

    NumberFormat format_;
    int F_;
    Table table_;
};

Table float_table(const NumberFormat& format) {
    Table table;
    const auto both = [&](std::int64_t raw, const std::string& what, const std::string& minus) {
        table.emplace(raw, what);
        table.emplace(raw | format.sign(), minus + what);
    };
    // As integers, the patterns of one sign are ordered by magnitude.
    const auto around = [&](const std::string& what, double number) {
        const std::int64_t raw = reference::raw_of_double(format, std::abs(number));
        const auto each = [&](std::int64_t magnitude, const std::string& where) {
            both(magnitude, what + where, "-");
        };
        each(raw, "");
        each(raw - 1, ", toward 0");
        each(raw + 1, ", away from 0");
    };
    const std::int64_t normal = std::int64_t(1) << (format.significand_bits() - 1);
    const int beyond = format.infinity_exponent();
    both(0, "0", "-");
    both(format.infinity(), "infinity", "-");
    table.emplace(format.infinity() | normal >> 1, "not a number");
    both(format.max(), "MAX", "-");
    both(1, "the smallest subnormal", "the negative of ");
    both(normal - 1, "the largest subnormal", "the negative of ");
    both(normal, "the smallest normal", "the negative of ");
    around("1", 1);
    around("0.5", 0.5);
    around(fmt::format("2^{}, above which odd integers are missing", format.significand_bits()),
           std::ldexp(1, format.significand_bits()));
    around("2^31", 0x1p31);
    around("the root of the smallest normal", std::ldexp(1, format.min_exponent() / 2));
    around(fmt::format("the root of 2^{}", beyond), std::ldexp(1, beyond / 2));
    around("ln MAX, the border of exp", beyond * std::numbers::ln2);
    around("ln of the smallest subnormal", format.min_place() * std::numbers::ln2);
    for (const int k : {1, 2, 3, 4, 5, 6, 7, 8, 16, 400})
        around(fmt::format("{} pi/4, rounded", k), k * std::numbers::pi / 4);
    for (int i = -5; i <= 5; ++i) {
        const int exponent = i * (beyond / 5 - 1);
        around(fmt::format("2^{}", exponent), std::ldexp(1, exponent));
    }
    return table;
}

// Products and quotients exactly halfway between two raws: with odd u and v, (u 2^i) (v 2^(F-1-i))
// / 2^F = u v / 2 and (u w 2^i) 2^F / (w 2^(F+1+i)) = u / 2. Powers of Q16.16 with the largest
// errors known, of bases just above 1 with the largest exponents: no random draw meets them.
std::vector<BoundaryCase> special_pairs(Operation operation, const NumberFormat& format) {
    std::vector<BoundaryCase> cases;
    const int F = format.fraction;
    const auto add = [&](const Integer& a, const Integer& b, const char* what) {
        const auto fits = [&](const Integer& raw) {
            return raw >= format.min() && raw <= format.max();
        };
        if (fits(a) && fits(b)) cases.push_back({{std::int64_t(a), std::int64_t(b)}, what});
    };
    for (const int u : {1, -1, 3, -3, 255, -255}) {
        for (const int v : {1, -1, 5, -127}) {
            if (operation == Operation::multiply) {
                for (int i = 0; i < F; ++i)
                    add(Integer(u) << i, Integer(v) << (F - 1 - i),
                        "a product half way between two raws");
            } else if (operation == Operation::divide) {
                for (int i = 0; F + 1 + i < format.width; ++i)
                    add(Integer(u * v) << i, Integer(v) << (F + 1 + i),
                        "a quotient half way between two raws");
            }
        }
    }
    if (operation == Operation::pow && format == reference::q16_16) {
        for (const auto& [base, exponent] : {std::pair(66049, 87173274), {66023, 91824685}})
            add(base, exponent, "a large power of a base just above 1");
    }
    return cases;
}

// A few operands of the table for operations of three and more.
std::vector<BoundaryOperand> few(const NumberFormat& format, std::size_t count) {
    const auto nearest = [&](int number) {
        if (format.is_float()) return reference::raw_of_double(format, number);
        return std::int64_t(std::clamp(Integer(number) << format.fraction, Integer(format.min()),
                                       Integer(format.max())));
    };
    const std::vector<BoundaryOperand> by_weight = {
        {format.max(), "MAX"}, {format.min(), "MIN"}, {nearest(-1), "-1"}, {1, "1 ulp"},
        {nearest(0), "0"},     {nearest(1), "1"},     {-1, "-1 ulp"},      {nearest(3), "3"},
    };
    std::vector<BoundaryOperand> held;
    for (const BoundaryOperand& operand : by_weight) {
        if (held.size() < count && !(format.is_unsigned && operand.raw < 0))
            held.push_back(operand);
    }
    return held;
}

std::vector<BoundaryCase> combinations(const std::vector<BoundaryOperand>& operands,
                                       std::size_t arity) {
    std::vector<BoundaryCase> cases = {{}};
    for (std::size_t i = 0; i < arity; ++i) {
        std::vector<BoundaryCase> longer;
        longer.reserve(cases.size() * operands.size());
        for (const BoundaryCase& start : cases) {
            for (const BoundaryOperand& operand : operands) {
                BoundaryCase extended = start;
                extended.operands.push_back(operand.raw);
                extended.what += (i > 0 ? "; " : "") + operand.what;
                longer.push_back(std::move(extended));
            }
        }
        cases = std::move(longer);
    }
    return cases;
}

std::vector<BoundaryCase> shifts(const NumberFormat& format) {
    std::vector<BoundaryCase> cases;
    for (const BoundaryOperand& operand : boundary_operands(format)) {
        for (int count = 0; count < format.width; ++count)
            cases.push_back({{operand.raw, count}, fmt::format("{}; by {}", operand.what, count)});
    }
    return cases;
}

std::vector<BoundaryCase> powers(const NumberFormat& format) {
    std::vector<BoundaryCase> cases;
    for (const BoundaryOperand& operand : boundary_operands(format)) {
        for (const int exponent :
             {0, 1, -1, 2, -2, 3, -3, 5, -8, 15, -16, 31, -32, 63, -64, 127, -128})
            cases.push_back({{operand.raw, integer(format, exponent)},
                             fmt::format("{}; to the {}", operand.what, exponent)});
    }
    return cases;
}

}  // namespace

std::vector<BoundaryOperand> boundary_operands(const NumberFormat& format) {
    std::vector<BoundaryOperand> operands;
    for (const auto& [raw, what] :
         format.is_float() ? float_table(format) : FixedTable(format).take())
        operands.push_back({raw, what});
    return operands;
}

std::vector<BoundaryCase> boundary_cases(Operation operation, const NumberFormat& format) {
    if (reference::is_shift(operation)) return shifts(format);
    if (operation == Operation::power) return powers(format);
    const std::size_t arity = reference::shape(operation).operands;
    switch (arity) {
        case 1:
            return combinations(boundary_operands(format), 1);
        case 2: {
            std::vector<BoundaryCase> cases = combinations(boundary_operands(format), 2);
            for (BoundaryCase& pair : special_pairs(operation, format))
                cases.push_back(std::move(pair));
            return cases;
        }
        case 3:
            return combinations(few(format, 8), 3);
        case 4:
            return combinations(few(format, 6), 4);
        default:
            return combinations(few(format, 4), arity);
    }
}

}  // namespace operands
