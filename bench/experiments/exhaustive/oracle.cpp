// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/exhaustive/oracle.hpp"

#include <array>
#include <cmath>

#include "reference/bulk.hpp"
#include "reference/judge.hpp"

namespace machine_code {
namespace {

using reference::Arithmetic;
using reference::Judgement;
using reference::NumberFormat;
using reference::Operation;
using reference::Subject;
using Raws = std::span<const std::int64_t>;

template <Subject subject>
Judgement judge(Raws operands, Raws results) {
    if constexpr (subject.operation == Operation::sincos) {
        constexpr Subject sine{Operation::sin, subject.format, subject.arithmetic};
        constexpr Subject cosine{Operation::cos, subject.format, subject.arithmetic};
        const Judgement s = reference::bulk::judge<sine>(operands, results[0]);
        const Judgement c = reference::bulk::judge<cosine>(operands, results[1]);
        Judgement worse = std::abs(s.error_ulp) >= std::abs(c.error_ulp) ? s : c;
        worse.as_defined = s.as_defined && c.as_defined;
        return worse;
    } else if constexpr (subject.operation == Operation::exp && subject.format.width == 64) {
        // No C type holds it to a fraction of its ulp.
        return reference::judge(subject, operands, results);
    } else {
        return reference::bulk::judge<subject>(operands, results);
    }
}

// Calls visit(operands, results) for each call.
template <Subject subject, class Visit>
void for_each_call(Raws operands, Raws results, Visit&& visit) {
    constexpr std::size_t arity = reference::shape(subject.operation).operands;
    constexpr std::size_t count = reference::shape(subject.operation).results;
    for (std::size_t i = 0; i < results.size() / count; ++i)
        visit(operands.subspan(i * arity, arity), results.subspan(i * count, count));
}

template <Subject subject>
void judge_all(Raws operands, Raws results, reference::ErrorStatistics& statistics) {
    for_each_call<subject>(operands, results, [&](Raws each, Raws computed) {
        statistics.add(judge<subject>(each, computed), each);
    });
}

template <Arithmetic arithmetic, NumberFormat format, Operation... operations>
void find(const reference::NamedSubject& named, std::optional<Oracle>& found) {
    ((named.subject == Subject{operations, format, arithmetic}
          ? void(found = Oracle{named.subject, judge<Subject{operations, format, arithmetic}>,
                                 judge_all<Subject{operations, format, arithmetic}>, nullptr})
          : void()),
     ...);
}

template <NumberFormat format>
void find_in_format(const reference::NamedSubject& named, std::optional<Oracle>& found) {
    using enum Operation;
    find<Arithmetic::nearest, format, add, subtract, multiply, divide, remainder, multiply_add,
         dot2, dot3, sqrt, reciprocal_sqrt, atan, atan2, sin, cos, sincos, exp, log, length2,
         length3, normalise3>(named, found);
    find<Arithmetic::saturating, format, add, subtract, multiply, divide>(named, found);
    find<Arithmetic::truncating, format, multiply, divide, sqrt>(named, found);
    find<Arithmetic::published, format, multiply, divide, sqrt, atan2>(named, found);
}

}  // namespace

std::optional<Oracle> oracle_of(const reference::NamedSubject& named) {
    std::optional<Oracle> found;
    find_in_format<reference::q4_4>(named, found);
    find_in_format<reference::q8_8>(named, found);
    find_in_format<reference::q16_16>(named, found);
    find_in_format<reference::q32_32>(named, found);
    if (!found) return found;
    for (const operations::HostSubject& host : operations::host_subjects())
        if (host.subject == named.subject && host.implementation == named.implementation)
            found->portable = &host;
    return found;
}

void Oracle::compare_all(std::span<const std::int64_t> operands,
                          std::span<const std::int64_t> results, Differences& found) const {
    const reference::OperationShape& shape = reference::shape(subject.operation);
    std::array<std::int64_t, reference::most_results> expected;
    for (std::size_t i = 0; i < results.size() / shape.results; ++i) {
        const Raws each = operands.subspan(i * shape.operands, shape.operands);
        portable->evaluate(each, std::span(expected).first(shape.results));
        bool same = true;
        for (std::size_t k = 0; k < shape.results; ++k)
            same &= results[i * shape.results + k] == expected[k];
        if (same) [[likely]]
            continue;
        if (found.count++ == 0) found.witness = reference::Witness(each);
    }
}

}  // namespace machine_code
