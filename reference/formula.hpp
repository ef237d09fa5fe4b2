// SPDX-License-Identifier: GPL-3.0-or-later
// The exact value of a formula that somebody wrote down: a*b/2^16, sqrt(a*2^16), atan2(a, b).
//
//     sum      = product { (+|-) product }
//     product  = sign { (*|/) sign }
//     sign     = [-] power
//     power    = primary [ ^ sign ]
//     primary  = number | pi | operand a..f | function ( sum {, sum} ) | ( sum )
//
// Functions: sqrt cbrt sin cos tan asin acos atan sinh cosh tanh exp exp2 log log2 log10 abs floor
// ceil trunc round (halves away from zero) of one operand, atan2 min max mod (sign of the first) of
// two.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>

#include "reference/numbers.hpp"

namespace reference {

class Formula {
  public:
    // The operands are a, b, c ..., as many as there are. Throws std::invalid_argument of one line
    // that says what was expected at which character.
    Formula(std::string_view text, std::size_t operands);

    // Over 300 bits of it; not finite where the formula has no value there.
    Real operator()(std::span<const Real> operands) const;

    struct Node;

  private:
    std::shared_ptr<const Node> root_;
};

}  // namespace reference
