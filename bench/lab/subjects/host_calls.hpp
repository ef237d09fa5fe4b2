// SPDX-License-Identifier: GPL-3.0-or-later
// What a host subject computes and how it is judged, for subjects known at compile time. The loops
// over calls are here, where the compiler can inline the callee.
#pragma once

#include <cstddef>
#include <fixedpoint/integer.hpp>
#include <utility>

#include "bench/lab/catalogue/invoke.h"
#include "bench/lab/subjects/host_subject.hpp"
#include "reference/bulk.hpp"
#include "reference/judge.hpp"

namespace operations {

// Calls visit(operands, results) for each call.
template <reference::Operation operation, class Results, class Visit>
void for_each_call(Raws operands, Results results, Visit&& visit) {
    constexpr std::size_t arity = reference::shape(operation).operands;
    constexpr std::size_t count = reference::shape(operation).results;
    for (std::size_t i = 0; i < results.size() / count; ++i)
        visit(operands.subspan(i * arity, arity), results.subspan(i * count, count));
}

// Calls the policy's function once, according to its signature.
template <reference::Operation operation, class Policy, class Raw, int F>
void call(Raws operands, std::span<std::int64_t> results) {
    constexpr std::size_t arity = reference::shape(operation).operands;
    constexpr std::size_t count = reference::shape(operation).results;
    constexpr std::size_t vectors = reference::vector_operands(operation);
    Raw raws[arity], computed[count];
    for (std::size_t i = 0; i < arity; ++i) raws[i] = static_cast<Raw>(operands[i]);

    const auto invoke = [&](auto... arguments) {
        if constexpr (count == 1)
            computed[0] = catalogue::invoke<operation, Policy, Raw, F>(arguments...);
        else
            catalogue::invoke<operation, Policy, Raw, F>(arguments..., computed);
    };
    const auto with = [&]<std::size_t... i>(std::index_sequence<i...>) {
        if constexpr (vectors == 0)
            invoke(raws[i]...);
        else
            invoke(static_cast<const Raw*>(raws + i * (arity / vectors))...);
    };
    with(std::make_index_sequence < vectors == 0 ? arity : vectors > ());
    for (std::size_t i = 0; i < count; ++i) results[i] = computed[i];
}

template <reference::Operation operation, class Policy, class Raw, int F>
void evaluate(Raws operands, std::span<std::int64_t> results) {
    for_each_call<operation>(operands, results, call<operation, Policy, Raw, F>);
}

// Functions are judged in binary128 where errors are compared, so that a search takes the same path
// on every processor. `Real` is a faster type for very many calls.
template <reference::Subject subject, class Real = reference::Binary128>
reference::Judgement judge(Raws operands, Raws results) {
    // The bulk judge does not support float, and no C type holds exp of a 64-bit format to a
    // fraction of its ulp.
    if constexpr (subject.format.is_float() || subject.operand_format.is_float() ||
                  (subject.operation == reference::Operation::exp && subject.format.width == 64)) {
        return reference::judge(subject, operands, results);
    } else {
        return reference::bulk::judge<subject, Real>(operands, results);
    }
}

template <reference::Subject subject>
void judge_all(Raws operands, Raws results, reference::ErrorStatistics& statistics,
               std::span<bool> regular) {
    constexpr int bits = subject.operand_format.width *
                         static_cast<int>(reference::shape(subject.operation).operands);
    using Fast = reference::bulk::FunctionFloat<subject.format.width>;
    using Real = std::conditional_t<(bits <= 16), reference::Binary128, Fast>;
    bool* next = regular.empty() ? nullptr : regular.data();
    for_each_call<subject.operation>(operands, results, [&](Raws each, Raws computed) {
        const reference::Judgement judgement = judge<subject, Real>(each, computed);
        statistics.add(judgement, each);
        if (next != nullptr) *next++ = judgement.regular();
    });
}

}  // namespace operations
