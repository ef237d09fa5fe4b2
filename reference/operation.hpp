// SPDX-License-Identifier: GPL-3.0-or-later
// The operations that are judged, by name, and the subject of a judgement: an operation in a format
// under the definitions of one arithmetic.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "reference/number_format.hpp"
#include "reference/operation_table.h"

namespace reference {

// The rows of operation_table.h as values.
enum class Signature {
    unary,
    binary,
    ternary,
    shift,
    conversion,
    pair,
    binary_pair,
    dot,
    length,
    direction
};
enum class Kind { ring, rounded, function };
enum class Domain {
    everywhere,
    nonzero_divisor,
    not_negative,
    positive,
    nonzero_vector,
    above_minus_one,
    unit_interval,  // -1 to 1
    power,          // x[0]^x[1]
    integer_power   // x[0]^x[1], x[1] an integer
};

struct OperationShape {
    Operation operation;
    std::string_view name;
    Signature signature;
    std::size_t operands;
    std::size_t results;
    Kind kind;
    double bound_ulp;
    Domain domain;
};

#define OPERATION_SHAPE(name, signature, operands, results, kind, bound_ulp, domain, ...) \
    OperationShape{Operation::name, #name,     Signature::signature, operands, results,   \
                   Kind::kind,      bound_ulp, Domain::domain},
inline constexpr std::array operations = {OPERATIONS(OPERATION_SHAPE)};
#undef OPERATION_SHAPE

inline constexpr std::size_t most_operands = 6;
inline constexpr std::size_t most_results = 3;

constexpr const OperationShape& shape(Operation operation) {
    return operations[std::size_t(operation)];
}

// How many vectors an operation takes as its operands; 0 where they are plain numbers.
constexpr std::size_t vector_operands(Operation operation) {
    switch (shape(operation).signature) {
        case Signature::dot:
            return 2;
        case Signature::length:
        case Signature::direction:
            return 1;
        default:
            return 0;
    }
}

constexpr bool is_shift(Operation operation) {
    return shape(operation).signature == Signature::shift;
}

// Whether an operand is an integer, of which the raw is the value.
constexpr bool takes_integer(Operation operation, std::size_t index) {
    return operation == Operation::isqrt ||
           (index == 1 && (is_shift(operation) || operation == Operation::power));
}
// Whether it is of the AUXILIARY_OPERATIONS, which the others and C's library do not have.
constexpr bool is_auxiliary(Operation operation) {
    switch (operation) {
#define AUXILIARY_CASE(name, ...) case Operation::name:
        AUXILIARY_OPERATIONS(AUXILIARY_CASE)
#undef AUXILIARY_CASE
        return true;
        default:
            return false;
    }
}
constexpr bool gives_integer_quotient(Operation operation) {
    return operation == Operation::divrem || operation == Operation::divmod;
}
// Whether the first result is one.
constexpr bool gives_integer(Operation operation) {
    return gives_integer_quotient(operation) || operation == Operation::sign ||
           operation == Operation::isqrt;
}

// Throws std::invalid_argument that lists the operations.
Operation parse_operation(std::string_view name);

// Whose definitions a result is held to.
enum class Arithmetic {
    nearest,     // the default: nearest, ties upward; ring operations wrap, everything else clamps
    published,   // the report's: truncation toward zero, the low W bits are kept
    saturating,  // nearest, and every operation clamps
    correctly_rounded,  // nearest, and functions round as the other operations do
    toward_zero,        // nearest, with another rounding of products, quotients and conversions
    downward,
    half_to_even,
    integer,  // C's integers: toward zero, wrapping; what C leaves undefined is not judged
    ieee,     // IEEE 754: nearest, ties to even, overflow to infinity
    accum,    // GCC's _Accum: the error is measured, overflow is undefined and not judged
};

struct Subject {
    Operation operation;
    NumberFormat format;
    Arithmetic arithmetic;
    NumberFormat operand_format = format;  // differs in a conversion only

    bool operator==(const Subject&) const = default;
};

// The definitions that an implementation in a format claims: float is IEEE 754, the _Accum formats
// GCC's, an integer C's; in fixed-point formats `published`, `saturating`, `correctly_rounded` and
// the roundings (also as a prefix: "saturating_small") name their own and every other
// implementation claims the default's.
Arithmetic arithmetic_of(const NumberFormat& format, std::string_view implementation);

// A subject and the implementation's name from a symbol <operation>_<format>_<implementation>, such
// as multiply_q16_16_default; convert_<operand format>_<format>_<implementation> for conversions.
struct NamedSubject {
    Subject subject;
    std::string implementation;
};
// Throws std::invalid_argument that says which part was not understood.
NamedSubject parse_symbol(std::string_view symbol);

}  // namespace reference
