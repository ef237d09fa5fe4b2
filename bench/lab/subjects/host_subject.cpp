// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/lab/subjects/host_subject.hpp"

#include <fmt/format.h>

#include <array>
#include <fixedpoint/arithmetic/nearest.hpp>
#include <fixedpoint/arithmetic/published.hpp>
#include <fixedpoint/arithmetic/saturating.hpp>
#include <fixedpoint/arithmetic/small.hpp>
#include <fixedpoint/portable/floating_point.hpp>
#include <string_view>
#include <type_traits>

#include "reference/bulk.hpp"
#include "reference/judge.hpp"

namespace operations {

namespace {

using reference::Arithmetic;
using reference::ErrorStatistics;
using reference::Judgement;
using reference::NumberFormat;
using reference::Operation;
using reference::Subject;

// Floating point is clamped and never wrapped, whatever the policy.
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

// Computes `operation` of the operands in the policy's arithmetic.
template <reference::Subject subject, class Policy>
void evaluate(std::span<const std::int64_t> operands, std::span<std::int64_t> results) {
    constexpr Operation operation = subject.operation;
    constexpr int F = subject.format.fraction;
    using Raw = fixedpoint::Integer<subject.format.width>;
    const auto raw = [&](std::size_t i) { return static_cast<Raw>(operands[i]); };

    if constexpr (operation == Operation::convert) {
        results[0] = converted<subject, Policy>(operands[0]);
    } else if constexpr (operation == Operation::add) {
        results[0] = Policy::template add<Raw, F>(raw(0), raw(1));
    } else if constexpr (operation == Operation::subtract) {
        results[0] = Policy::template subtract<Raw, F>(raw(0), raw(1));
    } else if constexpr (operation == Operation::multiply) {
        results[0] = Policy::template multiply<Raw, F>(raw(0), raw(1));
    } else if constexpr (operation == Operation::divide) {
        results[0] = Policy::template divide<Raw, F>(raw(0), raw(1));
    } else if constexpr (operation == Operation::remainder) {
        results[0] = Policy::template remainder<Raw, F>(raw(0), raw(1));
    } else if constexpr (operation == Operation::multiply_add) {
        results[0] = Policy::template multiply_add<Raw, F>(raw(0), raw(1), raw(2));
    } else if constexpr (operation == Operation::sqrt) {
        results[0] = Policy::template sqrt<Raw, F>(raw(0));
    } else if constexpr (operation == Operation::reciprocal_sqrt) {
        results[0] = Policy::template reciprocal_sqrt<Raw, F>(raw(0));
    } else if constexpr (operation == Operation::atan) {
        results[0] = Policy::template atan<Raw, F>(raw(0));
    } else if constexpr (operation == Operation::atan2) {
        results[0] = Policy::template atan2<Raw, F>(raw(0), raw(1));
    } else if constexpr (operation == Operation::sin) {
        results[0] = Policy::template sin<Raw, F>(raw(0));
    } else if constexpr (operation == Operation::cos) {
        results[0] = Policy::template cos<Raw, F>(raw(0));
    } else if constexpr (operation == Operation::exp) {
        results[0] = Policy::template exp<Raw, F>(raw(0));
    } else if constexpr (operation == Operation::log) {
        results[0] = Policy::template log<Raw, F>(raw(0));
    } else {
        constexpr std::size_t arity = reference::shape(operation).operands;
        Raw vectors[arity];
        for (std::size_t i = 0; i < arity; ++i) vectors[i] = raw(i);
        if constexpr (operation == Operation::dot2) {
            results[0] = Policy::template dot2<Raw, F>(vectors, vectors + 2);
        } else if constexpr (operation == Operation::dot3) {
            results[0] = Policy::template dot3<Raw, F>(vectors, vectors + 3);
        } else if constexpr (operation == Operation::length2) {
            results[0] = Policy::template length2<Raw, F>(vectors);
        } else if constexpr (operation == Operation::length3) {
            results[0] = Policy::template length3<Raw, F>(vectors);
        } else if constexpr (operation == Operation::normalise3) {
            Raw unit[3];
            Policy::template normalise3<Raw, F>(vectors, unit);
            for (std::size_t i = 0; i < 3; ++i) results[i] = unit[i];
        } else if constexpr (operation == Operation::sincos) {
            Raw both[2];
            Policy::template sincos<Raw, F>(vectors[0], both);
            results[0] = both[0];
            results[1] = both[1];
        } else {
            static_assert(operation == Operation::add, "This operation has no host subject.");
        }
    }
}

// Functions are judged in `Real`: by binary128 where errors are compared, so that a search takes
// the same way on every processor.
template <Subject subject, class Policy, class Real = reference::bulk::Binary128>
Judgement judge_one(std::span<const std::int64_t> operands) {
    constexpr std::size_t results = reference::shape(subject.operation).results;
    std::array<std::int64_t, results> computed;
    evaluate<subject, Policy>(operands, computed);
    // The fast judge has no float and no sincos, and no C type holds exp of a 64-bit format to a
    // fraction of its ulp.
    if constexpr (subject.format.is_float() || subject.operand_format.is_float() ||
                  subject.operation == Operation::sincos ||
                  (subject.operation == Operation::exp && subject.format.width == 64)) {
        return reference::judge(subject, operands, computed);
    } else {
        return reference::bulk::judge<subject, Real>(operands, computed);
    }
}

template <Subject subject, class Policy>
ErrorStatistics exhaust(std::uint64_t part) {
    constexpr NumberFormat format = subject.operand_format;
    constexpr std::size_t arity = reference::shape(subject.operation).operands;
    constexpr std::uint64_t inputs = std::uint64_t(1) << (format.width * arity);
    constexpr std::uint64_t share = inputs / exhaustive_parts;
    using Real =
        std::conditional_t<(format.width * arity <= 24), reference::bulk::Binary128, double>;
    ErrorStatistics statistics;
    std::array<std::int64_t, arity> operands;
    for (std::uint64_t i = part * share; i < (part + 1) * share; ++i) {
        for (std::size_t k = 0; k < arity; ++k) {
            operands[k] = format.sign_extend(i >> (k * format.width));
        }
        statistics.add(judge_one<subject, Policy, Real>(operands), operands);
    }
    return statistics;
}

template <Subject subject, class Policy>
void add_subject(std::vector<HostSubject>& subjects, const char* implementation) {
    constexpr int bits = subject.operand_format.width *
                         static_cast<int>(reference::shape(subject.operation).operands);
    const bool same_as_default = std::is_same_v<Policy, fixedpoint::Nearest> &&
                                 std::string_view(implementation) != "default";
    HostSubject host{subject,
                     implementation,
                     bits,
                     same_as_default,
                     evaluate<subject, Policy>,
                     judge_one<subject, Policy>,
                     nullptr};
    if constexpr (bits <= 32) host.exhaust = exhaust<subject, Policy>;
    subjects.push_back(std::move(host));
}

template <class Policy, Arithmetic arithmetic, NumberFormat format, Operation... operations>
void add_subjects(std::vector<HostSubject>& subjects, const char* implementation) {
    (add_subject<Subject{operations, format, arithmetic}, Policy>(subjects, implementation), ...);
}

template <NumberFormat format>
void add_format(std::vector<HostSubject>& subjects) {
    using enum Operation;
    add_subjects<fixedpoint::Nearest, Arithmetic::nearest, format, add, subtract, multiply, divide,
                 remainder, sqrt, atan, atan2, reciprocal_sqrt, sin, cos, sincos, exp, log,
                 multiply_add, dot2, dot3, length2, length3, normalise3>(subjects, "default");
    // The portable code by itself; on the host it is the default.
    add_subjects<fixedpoint::Nearest, Arithmetic::nearest, format, multiply, divide, sqrt>(
        subjects, "portable");
    add_subjects<fixedpoint::Published, Arithmetic::published, format, multiply, divide, sqrt,
                 atan2>(subjects, "published");
    add_subjects<fixedpoint::Saturating, Arithmetic::saturating, format, add, subtract, multiply>(
        subjects, "saturating");
}

// A split whose functions run through the generic code: what has kernels of its own.
template <NumberFormat format>
void add_split(std::vector<HostSubject>& subjects) {
    using enum Operation;
    add_subjects<fixedpoint::Nearest, Arithmetic::nearest, format, add, subtract, multiply, divide,
                 remainder, sqrt, multiply_add, dot2, dot3, length2, length3, normalise3>(
        subjects, "default");
}

template <NumberFormat from, NumberFormat to>
void add_conversion(std::vector<HostSubject>& subjects) {
    using enum Arithmetic;
    add_subject<Subject{Operation::convert, to, to.is_float() ? ieee : nearest, from},
                fixedpoint::Nearest>(subjects, "default");
    if constexpr (!to.is_float() && !from.is_float()) {
        add_subject<Subject{Operation::convert, to, saturating, from}, fixedpoint::Saturating>(
            subjects, "saturating");
    }
}

template <NumberFormat one, NumberFormat other>
void add_conversions(std::vector<HostSubject>& subjects) {
    add_conversion<one, other>(subjects);
    add_conversion<other, one>(subjects);
}

}  // namespace

std::string operation_name(const reference::Subject& subject) {
    const std::string_view name = reference::shape(subject.operation).name;
    if (subject.operation != Operation::convert) return std::string(name);
    return fmt::format("{}_{}", name, reference::format_name(subject.operand_format));
}

std::string HostSubject::name() const {
    return fmt::format("{}_{}_{}", operation_name(subject), reference::format_name(subject.format),
                       implementation);
}

const std::vector<HostSubject>& host_subjects() {
    static const std::vector<HostSubject> all = [] {
        std::vector<HostSubject> subjects;
        add_format<reference::q4_4>(subjects);
        add_format<reference::q8_8>(subjects);
        add_format<reference::q16_16>(subjects);
        add_split<reference::fixed_format(8, 24)>(subjects);
        add_format<reference::q32_32>(subjects);
        add_conversions<reference::q8_8, reference::q4_4>(subjects);
        add_conversions<reference::q16_16, reference::q8_8>(subjects);
        add_conversions<reference::q32_32, reference::q16_16>(subjects);
        add_conversions<reference::q4_4, reference::ieee_single>(subjects);
        add_conversions<reference::q8_8, reference::ieee_single>(subjects);
        add_conversions<reference::q16_16, reference::ieee_single>(subjects);
        add_conversions<reference::q32_32, reference::ieee_single>(subjects);
        using enum Operation;
        add_subjects<fixedpoint::Nearest, Arithmetic::nearest, reference::q16_16, divide>(
            subjects, "widening");
        add_subjects<fixedpoint::Small, Arithmetic::nearest, reference::q16_16, sqrt,
                     reciprocal_sqrt, atan, atan2, sin, cos, sincos, exp, log>(subjects, "small");
        return subjects;
    }();
    return all;
}

}  // namespace operations
