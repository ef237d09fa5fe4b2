// SPDX-License-Identifier: GPL-3.0-or-later
// The host subjects that convert between formats.
#include <fixedpoint/arithmetic/nearest.hpp>
#include <fixedpoint/arithmetic/saturating.hpp>
#include <fixedpoint/portable/floating_point.hpp>

#include "bench/lab/subjects/host_calls.hpp"

namespace operations {
namespace {

using reference::Arithmetic;
using reference::ieee_single;
using reference::NumberFormat;
using reference::Operation;
using reference::Subject;

// Floating point saturates and never wraps, whatever the policy.
template <Subject subject, class Policy>
std::int64_t converted(std::int64_t operand) {
    constexpr NumberFormat to = subject.format, from = subject.operand_format;
    if constexpr (from.is_float()) {
        return fixedpoint::portable::from_float<fixedpoint::Integer<to.width>, to.fraction>(
                   reference::float_of_raw(operand))
            .number;
    } else {
        using From = fixedpoint::Integer<from.width>;
        const From raw = static_cast<From>(operand);
        if constexpr (to.is_float()) {
            return reference::raw_of_float(
                fixedpoint::portable::to_float<float, From, from.fraction>(raw));
        } else {
            return Policy::template convert<fixedpoint::Integer<to.width>, to.fraction, From,
                                            from.fraction>(raw);
        }
    }
}

template <Subject subject, class Policy>
void convert(Raws operands, std::span<std::int64_t> results) {
    for (std::size_t i = 0; i < results.size(); ++i)
        results[i] = converted<subject, Policy>(operands[i]);
}

template <Subject subject, class Policy>
void add(std::vector<HostSubject>& subjects, const char* implementation) {
    subjects.push_back({subject, implementation, false, convert<subject, Policy>,
                        judge_all<subject>, judge<subject>});
}

template <NumberFormat from, NumberFormat to>
void add_conversion(std::vector<HostSubject>& subjects) {
    add<Subject{Operation::convert, to, to.is_float() ? Arithmetic::ieee : Arithmetic::nearest,
                from},
        fixedpoint::Nearest>(subjects, "default");
    if constexpr (!to.is_float() && !from.is_float())
        add<Subject{Operation::convert, to, Arithmetic::saturating, from}, fixedpoint::Saturating>(
            subjects, "saturating");
}

template <NumberFormat one, NumberFormat other>
void add_both_ways(std::vector<HostSubject>& subjects) {
    add_conversion<one, other>(subjects);
    add_conversion<other, one>(subjects);
}

}  // namespace

void add_conversions(std::vector<HostSubject>& subjects) {
    using namespace reference;
    add_both_ways<q8_8, q4_4>(subjects);
    add_both_ways<q16_16, q8_8>(subjects);
    add_both_ways<q32_32, q16_16>(subjects);
    add_both_ways<q4_4, ieee_single>(subjects);
    add_both_ways<q8_8, ieee_single>(subjects);
    add_both_ways<q16_16, ieee_single>(subjects);
    add_both_ways<q32_32, ieee_single>(subjects);
}

}  // namespace operations
