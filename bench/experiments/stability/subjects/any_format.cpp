// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/any_format.hpp"

#include "bench/experiments/stability/world_of.hpp"

namespace stability {

template <>
struct RunStep<AnyFormat> {
    int exponent;
    AnyFormat seconds;
    bool binary;

    operator AnyFormat() const {
        if (!binary) return seconds;
        bool fits;
        return AnyFormat::nearest(std::ldexp(1.0, -exponent), fits);
    }
    friend AnyFormat operator*(AnyFormat a, RunStep dt) {
        return dt.binary ? scaled_down(a, dt.exponent) : a * dt.seconds;
    }
    friend AnyFormat carried_product(AnyFormat a, RunStep dt, AnyFormat& residual) {
        return dt.binary ? AnyFormat::carried_shift(a, dt.exponent, residual) : a * dt.seconds;
    }
    friend RunStep half(RunStep dt) { return {dt.exponent + 1, half(dt.seconds), dt.binary}; }
};
template <>
struct Rounding<AnyFormat> {
    std::string unfit, vanished;
    AnyFormat operator()(double x, const char* name) {
        bool fits;
        const AnyFormat rounded = AnyFormat::nearest(x, fits);
        if (!fits && unfit.empty()) unfit = name;
        if (fits && rounded.raw() == 0 && x != 0 && is_essential(name) && vanished.empty())
            vanished = name;
        return rounded;
    }
};
template <>
double to_double(AnyFormat x) {
    return std::ldexp(static_cast<double>(x.raw()), -AnyFormat::split().fraction_bits);
}

std::vector<Subject> subjects_of_any_format(Split split) {
    AnyFormat::split() = split;
    const double ulp = std::ldexp(1.0, -split.fraction_bits);
    return subjects_with<AnyFormat>("any", "nearest", ulp * static_cast<double>(split.most()), ulp);
}

std::vector<Subject> more_subjects_of_any_format(Split split) {
    AnyFormat::split() = split;
    const double ulp = std::ldexp(1.0, -split.fraction_bits);
    return subjects_of_methods<AnyFormat, OneIteration, WarmStarted, ContinuousContacts>(
        "any", "nearest", ulp * static_cast<double>(split.most()), ulp);
}

}  // namespace stability
