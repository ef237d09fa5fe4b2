// SPDX-License-Identifier: MIT
// sqrt: sqrt(a 2^F) rounded to nearest (never a tie); 0 where a < 0.
#pragma once

#include <fixedpoint/portable/nearest_root.hpp>

namespace fixedpoint {
namespace portable {

template <class Raw, int F>
constexpr Raw sqrt(Raw a) {
    using Word = Unsigned<Raw>;
    // Two shifts, as one by W would be undefined where F is 0.
    return a <= 0 ? Raw(0)
                  : nearest_root<Raw>(
                        static_cast<Word>(static_cast<Word>(a) >> 1 >> (width_of<Raw> - 1 - F)),
                        static_cast<Word>(static_cast<Word>(a) << F));
}

}  // namespace portable
}  // namespace fixedpoint
