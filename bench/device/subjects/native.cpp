// SPDX-License-Identifier: GPL-3.0-or-later
// The compiler's own integers: what an operation costs without any fixed point.
#include <fixedpoint/integer.hpp>

#include "subject.h"

using fixedpoint::Unsigned;

// Sums and products wrap, like the machine's: computed unsigned, where that is defined.
struct Native {
    template <class Raw, int F>
    static constexpr Raw add(Raw a, Raw b) {
        return Raw(Unsigned<Raw>(a) + Unsigned<Raw>(b));
    }
    template <class Raw, int F>
    static constexpr Raw subtract(Raw a, Raw b) {
        return Raw(Unsigned<Raw>(a) - Unsigned<Raw>(b));
    }
    template <class Raw, int F>
    static constexpr Raw multiply(Raw a, Raw b) {
        return Raw(Unsigned<Raw>(a) * Unsigned<Raw>(b));
    }
    template <class Raw, int F>
    static constexpr Raw divide(Raw a, Raw b) {
        return Raw(a / b);
    }
    template <class Raw, int F>
    static constexpr Raw remainder(Raw a, Raw b) {
        return Raw(a % b);
    }
};

IMPLEMENTATION_native(SUBJECTS)
