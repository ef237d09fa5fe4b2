// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/operation.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace reference {
namespace {

constexpr bool rows_fit_their_limits() {
    for (const OperationShape& row : operations)
        if (row.operands > max_operands || row.results > max_results) return false;
    return true;
}
static_assert(rows_fit_their_limits(), "Arrays of operands and results are of these sizes.");

// The longest operation name that starts the symbol and is followed by an underscore.
const OperationShape* leading_operation(std::string_view symbol) {
    const OperationShape* found = nullptr;
    for (const OperationShape& candidate : operations) {
        if (symbol.starts_with(candidate.name) &&
            symbol.substr(candidate.name.size()).starts_with("_") &&
            (!found || candidate.name.size() > found->name.size())) {
            found = &candidate;
        }
    }
    return found;
}

// Removes the format that `rest` starts with, and the underscore after it, and returns the format.
NumberFormat take_format(std::string_view& rest) {
    const bool split = rest.starts_with("q") || rest.starts_with("s") || rest.starts_with("u");
    const std::size_t first = rest.find('_');
    const std::size_t end = split && first != rest.npos ? rest.find('_', first + 1) : first;
    const NumberFormat format = parse_format(rest.substr(0, end));
    rest.remove_prefix(end == rest.npos ? rest.size() : end + 1);
    return format;
}

}  // namespace

Operation parse_operation(std::string_view name) {
    std::string allowed;
    for (const OperationShape& candidate : operations) {
        if (candidate.name == name) return candidate.operation;
        allowed.append(" ").append(candidate.name);
    }
    throw std::invalid_argument(
        fmt::format("unknown operation '{}': allowed are{}", name, allowed));
}

Arithmetic arithmetic_of(const NumberFormat& format, std::string_view implementation) {
    switch (format.kind) {
        case FormatKind::integer:
            return Arithmetic::integer;
        case FormatKind::ieee:
            return Arithmetic::ieee;
        case FormatKind::accum:
            return Arithmetic::accum;
        case FormatKind::fixed:
            break;
    }
    if (implementation.starts_with("published")) return Arithmetic::published;
    if (implementation.starts_with("saturating")) return Arithmetic::saturating;
    if (implementation.starts_with("correctly_rounded")) return Arithmetic::correctly_rounded;
    if (implementation.starts_with("toward_zero")) return Arithmetic::toward_zero;
    if (implementation.starts_with("downward")) return Arithmetic::downward;
    if (implementation.starts_with("half_to_even")) return Arithmetic::half_to_even;
    return Arithmetic::nearest;
}

NamedSubject parse_symbol(std::string_view symbol) try {
    const OperationShape* operation = leading_operation(symbol);
    if (!operation) throw std::invalid_argument("it does not start with a known operation");
    std::string_view rest = symbol.substr(operation->name.size() + 1);
    const NumberFormat first = take_format(rest);
    const NumberFormat format =
        operation->operation == Operation::convert ? take_format(rest) : first;
    if (rest.empty()) throw std::invalid_argument("no implementation follows the format");
    // A conversion is held to the definition of its fixed-point side, of the operand if both are.
    const NumberFormat& side = first.kind == FormatKind::fixed ? first : format;
    return {{operation->operation, format, arithmetic_of(side, rest), first}, std::string(rest)};
} catch (const std::invalid_argument& error) {
    throw std::invalid_argument(fmt::format(
        "the symbol '{}' is not <operation>_<format>_<implementation>: {}", symbol, error.what()));
}

}  // namespace reference
