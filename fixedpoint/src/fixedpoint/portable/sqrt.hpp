// SPDX-License-Identifier: MIT
// sqrt: sqrt(a 2^F) rounded to nearest (never a tie); 0 if a < 0.
#pragma once

#include <fixedpoint/portable/nearest_root.hpp>

namespace fixedpoint {
namespace portable {

template <class Raw, int F>
FIXEDPOINT_CONSTEXPR Raw sqrt(Raw a) {
    using Word = Unsigned<Raw>;
    // a 2^F in two words. In two shifts each, since a single shift by W would be undefined if F is
    // 0 or W.
    constexpr int low = F / 2, high = (RawLimits<Raw>::width - F) / 2;
    return a <= 0 ? Raw(0)
                  : nearest_root<Raw>(static_cast<Word>(static_cast<Word>(a) >> high >>
                                                        (RawLimits<Raw>::width - F - high)),
                                      static_cast<Word>(static_cast<Word>(a) << low << (F - low)));
}

}  // namespace portable
}  // namespace fixedpoint
