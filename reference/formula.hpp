// SPDX-License-Identifier: GPL-3.0-or-later
// The exact value of a formula that the user wrote: a*b/2^16, sqrt(a*2^16), atan2(a, b).
//
//     sum      = product { (+|-) product }
//     product  = sign { (*|/) sign }
//     sign     = [-] power
//     power    = primary [ ^ sign ]
//     primary  = number | pi | operand a..f | function ( sum {, sum} ) | ( sum )
//
// Functions of one operand: sqrt cbrt sin cos tan asin acos atan sinh cosh tanh exp exp2 log log2
// log10 abs floor ceil trunc round (halves away from zero). Of two: atan2 min max mod (sign of the
// first).
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>

#include "reference/numbers.hpp"

namespace reference {

class Formula {
  public:
    // The operands are named a, b, c ..., up to the number `operands`. Throws std::invalid_argument
    // with one line that says what was expected at which character.
    Formula(std::string_view text, std::size_t operands);

    // The value, to over 300 bits; not finite where the formula has none.
    Real operator()(std::span<const Real> operands) const;

    struct Node;

  private:
    std::shared_ptr<const Node> root_;
};

}  // namespace reference
