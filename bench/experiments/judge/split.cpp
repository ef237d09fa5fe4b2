// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/judge/split.hpp"

#include "reference/bulk.hpp"
#include "reference/judge.hpp"

namespace judge {
namespace {

using reference::Judgement;
using reference::NumberFormat;
using reference::Operation;
using Raws = std::span<const std::int64_t>;

constexpr double doubt = 0x1p-13;  // ulp: twice the bound of a function's error in double

constexpr bool is_function(Operation operation) {
    return reference::shape(operation).kind == reference::Kind::function;
}

template <Operation operation, int width>
constexpr bool is_judged_here() {
    if (operation == Operation::length2 || operation == Operation::length3) return true;
    if (reference::takes_integer(operation, 1) || operation == Operation::convert) return false;
    return reference::shape(operation).results == 1 &&
           (is_function(operation) ? width <= 32 : !reference::is_auxiliary(operation));
}

template <Operation operation, int width>
Judgement judge_split(const NumberFormat& format, Raws operands, Raws results) {
    // The definition and the range do not depend on the split.
    constexpr reference::Subject subject{
        operation, {reference::FormatKind::fixed, width, 0}, reference::Arithmetic::nearest};
    namespace bulk = reference::bulk;
    using Number = bulk::Wide<width>;
    const int F = format.fraction;
    const auto raw = [&](std::size_t i) { return Number(operands[i]); };
    const std::int64_t result = results[0];
    const auto whole = [&](auto n) {
        return bulk::judge_quotient<subject, 0>(n, Number(1), result);
    };
    const auto product = [&](auto n) {
        return bulk::judge_quotient<subject>(n, Number(1) << F, result);
    };

    if (!reference::in_domain(operation, operands, reference::raw_one(format)))
        return bulk::pinned(reference::outside_domain(operation, format, operands[0]), result);
    if constexpr (operation == Operation::add) {
        return whole(raw(0) + raw(1));
    } else if constexpr (operation == Operation::subtract) {
        return whole(raw(0) - raw(1));
    } else if constexpr (operation == Operation::negate) {
        return whole(-raw(0));
    } else if constexpr (operation == Operation::abs) {
        return whole(operands[0] < 0 ? -raw(0) : raw(0));
    } else if constexpr (operation == Operation::remainder) {
        return whole(raw(0) % raw(1));
    } else if constexpr (operation == Operation::multiply) {
        return product(raw(0) * raw(1));
    } else if constexpr (operation == Operation::multiply_add) {
        return product(raw(0) * raw(1) + (raw(2) << F));
    } else if constexpr (operation == Operation::dot2 || operation == Operation::dot3) {
        constexpr std::size_t dimensions = reference::shape(operation).operands / 2;
        Number total = 0;
        for (std::size_t i = 0; i < dimensions; ++i)
            total = bulk::sum(total, raw(i) * raw(dimensions + i));
        return product(total);
    } else if constexpr (operation == Operation::divide) {
        const Number n = raw(0) << F, d = raw(1);
        return bulk::judge_quotient<subject>(d < 0 ? -n : n, d < 0 ? -d : d, result);
    } else if constexpr (operation == Operation::sqrt) {
        return bulk::judge_root<subject>(operands[0], result, F);
    } else if constexpr (operation == Operation::length2 || operation == Operation::length3) {
        return bulk::judge_length<subject>(operands, result);
    } else {
        double x[2] = {};
        for (std::size_t i = 0; i < operands.size(); ++i)
            x[i] = std::ldexp(static_cast<double>(operands[i]), -F);
        const double exact = std::ldexp(reference::function(operation, x), F);
        // Where double cannot decide on which side of a limit the value lies, 300 bits can.
        constexpr double bound = reference::definition(subject).bound_ulp;
        constexpr double limits[] = {subject.format.min() - 0.5, -0.5, 0.5,
                                     subject.format.max() + 0.5};
        bool is_close = std::abs(std::abs(static_cast<double>(result) - exact) - bound) < doubt;
        for (const double limit : limits) is_close |= std::abs(exact - limit) < doubt;
        if (is_close)
            return reference::judge({operation, format, reference::Arithmetic::nearest}, operands,
                                    results);
        return bulk::judge_function<subject>(exact, result);
    }
}

template <int width>
SplitJudge of_width(Operation wanted) {
#define IF_WANTED(name, ...)                                \
    if constexpr (is_judged_here<Operation::name, width>()) \
        if (wanted == Operation::name) return judge_split<Operation::name, width>;
    OPERATIONS(IF_WANTED)
#undef IF_WANTED
    return nullptr;
}

}  // namespace

SplitJudge split_judge(const reference::Subject& subject) {
    if (subject.format.kind != reference::FormatKind::fixed ||
        subject.operand_format != subject.format ||
        subject.arithmetic != reference::Arithmetic::nearest)
        return nullptr;
    // A turn of 2^64 and as many fraction bits would exceed the 128 bits that bulk uses.
    if (subject.format.fraction > 62) return nullptr;
    switch (subject.format.width) {
        case 8:
            return of_width<8>(subject.operation);
        case 16:
            return of_width<16>(subject.operation);
        case 32:
            return of_width<32>(subject.operation);
        case 64:
            return of_width<64>(subject.operation);
        default:
            return nullptr;
    }
}

}  // namespace judge
