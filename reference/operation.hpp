// SPDX-License-Identifier: GPL-3.0-or-later
// The operations that are judged, by name, and the subject of a judgement: an operation in a
// format, held to the definitions of one arithmetic.
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
    power,          // a^b
    integer_power   // a^n, n an integer
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

inline constexpr std::size_t max_operands = 6;
inline constexpr std::size_t max_results = 3;

constexpr const OperationShape& shape(Operation operation) {
    return operations[std::size_t(operation)];
}

// How many vectors an operation takes; 0 if its operands are plain numbers.
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

// Whether an operand is an integer, whose raw is its value.
constexpr bool takes_integer(Operation operation, std::size_t index) {
    return operation == Operation::isqrt ||
           (index == 1 && (is_shift(operation) || operation == Operation::power));
}
// Whether it is one of the AUXILIARY_OPERATIONS, for which C defines no special cases.
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
// Whether the first result is an integer.
constexpr bool gives_integer(Operation operation) {
    return gives_integer_quotient(operation) || operation == Operation::sign ||
           operation == Operation::isqrt;
}

// Throws std::invalid_argument for an unknown name, with a message that lists the operations.
Operation parse_operation(std::string_view name);

// The definitions that a result is held to.
enum class Arithmetic {
    nearest,            // the default: round half up; ring operations wrap, all others saturate
    published,          // the 2016 design's: truncates toward zero, keeps the low W bits
    saturating,         // nearest, but every operation saturates
    correctly_rounded,  // nearest, but functions are rounded like the other operations
    toward_zero,        // nearest, but with another rounding of products, quotients and conversions
    downward,
    half_to_even,
    integer,  // C's integers: toward zero, wrapping; what C leaves undefined is not judged
    ieee,     // IEEE 754: round half to even, overflow to infinity
    accum,    // GCC's _Accum: the error is measured; overflow is undefined and not judged
};

struct Subject {
    Operation operation;
    NumberFormat format;
    Arithmetic arithmetic;
    NumberFormat operand_format = format;  // differs in a conversion only

    bool operator==(const Subject&) const = default;
};

// The definitions that an implementation in a format claims: float those of IEEE 754, the _Accum
// formats GCC's, an integer C's. In a fixed-point format `published`, `saturating`,
// `correctly_rounded` and the roundings (also as a prefix: "saturating_small") claim their own;
// every other implementation claims the default's.
Arithmetic arithmetic_of(const NumberFormat& format, std::string_view implementation);

// A subject and the name of the implementation, read from a symbol
// <operation>_<format>_<implementation> such as multiply_q16_16_default, or convert_<operand
// format>_<format>_<implementation> for conversions.
struct NamedSubject {
    Subject subject;
    std::string implementation;
};
// Throws std::invalid_argument for any other symbol, with a message that says which part is wrong.
NamedSubject parse_symbol(std::string_view symbol);

}  // namespace reference
