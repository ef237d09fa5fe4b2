// SPDX-License-Identifier: GPL-3.0-or-later
// The operations that are judged, by name, and the subject of a judgement: an operation in a format
// under the definitions of one arithmetic.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

#include "reference/number_format.hpp"

namespace reference {

// Vectors lie one after the other: the operands of dot3 are a0 a1 a2 b0 b1 b2. atan2 takes y, x.
// The second operand of a shift is a count, a plain integer. The results of sincos are sine and
// cosine.
enum class Operation {
    add,
    subtract,
    multiply,
    divide,
    remainder,
    negate,
    abs,
    shift_left,
    shift_right,
    convert,
    multiply_add,
    dot2,
    dot3,
    sqrt,
    reciprocal_sqrt,
    atan,
    atan2,
    sin,
    cos,
    sincos,
    exp,
    log,
    length2,
    length3,
    normalise3,
};

struct OperationShape {
    Operation operation;
    std::string_view name;
    std::size_t operands;
    std::size_t results;
};

inline constexpr std::array operations = {
    OperationShape{Operation::add, "add", 2, 1},
    OperationShape{Operation::subtract, "subtract", 2, 1},
    OperationShape{Operation::multiply, "multiply", 2, 1},
    OperationShape{Operation::divide, "divide", 2, 1},
    OperationShape{Operation::remainder, "remainder", 2, 1},
    OperationShape{Operation::negate, "negate", 1, 1},
    OperationShape{Operation::abs, "abs", 1, 1},
    OperationShape{Operation::shift_left, "shift_left", 2, 1},
    OperationShape{Operation::shift_right, "shift_right", 2, 1},
    OperationShape{Operation::convert, "convert", 1, 1},
    OperationShape{Operation::multiply_add, "multiply_add", 3, 1},
    OperationShape{Operation::dot2, "dot2", 4, 1},
    OperationShape{Operation::dot3, "dot3", 6, 1},
    OperationShape{Operation::sqrt, "sqrt", 1, 1},
    OperationShape{Operation::reciprocal_sqrt, "reciprocal_sqrt", 1, 1},
    OperationShape{Operation::atan, "atan", 1, 1},
    OperationShape{Operation::atan2, "atan2", 2, 1},
    OperationShape{Operation::sin, "sin", 1, 1},
    OperationShape{Operation::cos, "cos", 1, 1},
    OperationShape{Operation::sincos, "sincos", 1, 2},
    OperationShape{Operation::exp, "exp", 1, 1},
    OperationShape{Operation::log, "log", 1, 1},
    OperationShape{Operation::length2, "length2", 2, 1},
    OperationShape{Operation::length3, "length3", 3, 1},
    OperationShape{Operation::normalise3, "normalise3", 3, 3},
};
inline constexpr std::size_t most_operands = 6;
inline constexpr std::size_t most_results = 3;

constexpr const OperationShape& shape(Operation operation) {
    return operations[std::size_t(operation)];
}

// How many vectors an operation takes as its operands; 0 where they are plain numbers.
constexpr std::size_t vector_operands(Operation operation) {
    switch (operation) {
        case Operation::dot2:
        case Operation::dot3:
            return 2;
        case Operation::length2:
        case Operation::length3:
        case Operation::normalise3:
            return 1;
        default:
            return 0;
    }
}

// Throws std::invalid_argument that lists the operations.
Operation parse_operation(std::string_view name);

// Whose definitions a result is held to.
enum class Arithmetic {
    nearest,     // the default: nearest, ties upward; ring operations wrap, everything else clamps
    published,   // the report's: truncation toward zero, the low W bits are kept
    saturating,  // nearest, and every operation clamps
    truncating,  // as the default with truncation toward zero in place of the rounding
    integer,     // C's integers: toward zero, wrapping; what C leaves undefined is not judged
    ieee,        // IEEE 754: nearest, ties to even, overflow to infinity
    accum,       // GCC's _Accum: the error is measured, overflow is undefined and not judged
};

struct Subject {
    Operation operation;
    NumberFormat format;
    Arithmetic arithmetic;
    NumberFormat operand_format = format;  // differs in a conversion only

    bool operator==(const Subject&) const = default;
};

// The definitions that an implementation in a format claims: float is IEEE 754, the _Accum formats
// GCC's, an integer C's; in fixed-point formats `published`, `saturating` and `truncating` (also as
// a prefix: "saturating_small") name their own and every other implementation claims the default's.
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
