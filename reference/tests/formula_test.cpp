// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/formula.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "reference/exact.hpp"

namespace reference {
namespace {

double value(const std::string& text, std::vector<Real> operands = {}) {
    return double(Formula(text, operands.size())(operands));
}

TEST(Formula, BindsAsMathematicsDoes) {
    EXPECT_EQ(value("1+2*3"), 7);
    EXPECT_EQ(value("1 - 2 - 3"), -4);
    EXPECT_EQ(value("8/4/2"), 1);
    EXPECT_EQ(value("-2^2"), -4);
    EXPECT_EQ(value("2^-1"), 0.5);
    EXPECT_EQ(value("2^3^2"), 512);
    EXPECT_EQ(value("(1+2)*3"), 9);
    EXPECT_EQ(value("2*-3"), -6);
    EXPECT_EQ(value("a*b/2^16", {Real(3 << 16), Real(5)}), 15);
    EXPECT_EQ(value("f-a", {1, 2, 3, 4, 5, 6}), 5);
}

TEST(Formula, FunctionsAreThoseOfTheCLibrary) {
    const double x = 0.59375;
#define EXPECT_AS_IN_C(name) EXPECT_DOUBLE_EQ(value(#name "(a)", {Real(x)}), std::name(x))
    EXPECT_AS_IN_C(sqrt);
    EXPECT_AS_IN_C(cbrt);
    EXPECT_AS_IN_C(sin);
    EXPECT_AS_IN_C(cos);
    EXPECT_AS_IN_C(tan);
    EXPECT_AS_IN_C(asin);
    EXPECT_AS_IN_C(acos);
    EXPECT_AS_IN_C(atan);
    EXPECT_AS_IN_C(sinh);
    EXPECT_AS_IN_C(cosh);
    EXPECT_AS_IN_C(tanh);
    EXPECT_AS_IN_C(exp);
    EXPECT_AS_IN_C(exp2);
    EXPECT_AS_IN_C(log);
    EXPECT_AS_IN_C(log2);
    EXPECT_AS_IN_C(log10);
    EXPECT_AS_IN_C(floor);
    EXPECT_AS_IN_C(ceil);
    EXPECT_AS_IN_C(trunc);
    EXPECT_AS_IN_C(round);
    EXPECT_DOUBLE_EQ(value("atan2(a, b)", {Real(1), Real(-2)}), std::atan2(1, -2));
    EXPECT_EQ(value("mod(a,b)", {Real(-7), Real(4)}), -3);
    EXPECT_EQ(value("min(a,b) + 10*max(a,b)", {Real(2), Real(3)}), 32);
    EXPECT_EQ(value("abs(-a)", {Real(2)}), 2);
    EXPECT_DOUBLE_EQ(value("pi"), M_PI);
}

TEST(Formula, ProductsOf64BitsAreExact) {
    const Real big("9223372036854775807");
    const Real operands[] = {big, big, Real(1)};
    EXPECT_EQ(Formula("a*b+c-a*b", 3)(operands), 1);
}

TEST(Formula, IsNotFiniteWhereUndefined) {
    EXPECT_FALSE(std::isfinite(value("1/a", {Real(0)})));
    EXPECT_FALSE(std::isfinite(value("sqrt(a)", {Real(-1)})));
    EXPECT_FALSE(std::isfinite(value("log(a)", {Real(0)})));
}

TEST(Formula, RefusesInvalidText) {
    const auto refusal = [](const std::string& text, std::size_t operands) -> std::string {
        try {
            Formula(text, operands);
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(refusal("a*", 1),
              "the formula 'a*' needs a number, an operand, a function or '(' at character 3");
    EXPECT_EQ(refusal("a+b", 1),
              "the formula 'a+b' needs the operand a, or a function at character 3");
    EXPECT_EQ(refusal("a+d", 3),
              "the formula 'a+d' needs an operand a..c, or a function at character 3");
    EXPECT_EQ(refusal("(a", 1), "the formula '(a' needs ')' at character 3");
    EXPECT_EQ(refusal("a b", 2), "the formula 'a b' needs an operator or the end at character 3");
    EXPECT_EQ(refusal("atan2(a)", 1),
              "the formula 'atan2(a)' needs 2 operands of atan2 at character 8");
    EXPECT_EQ(refusal("1.2.3", 0), "the formula '1.2.3' needs a number at character 1");
    EXPECT_NE(refusal("", 0), "");
    EXPECT_NE(refusal(std::string(10000, '('), 0), "");
    EXPECT_NE(refusal(std::string(10000, '-'), 0), "");
}

}  // namespace
}  // namespace reference
