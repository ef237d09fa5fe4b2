// SPDX-License-Identifier: GPL-3.0-or-later
// The portable C++ that the assembly kernels replace: the compiler's code for the same results.
#include <fixedpoint/portable/divide.hpp>
#include <fixedpoint/portable/divide_widening.hpp>
#include <fixedpoint/portable/multiply.hpp>
#include <fixedpoint/portable/sqrt.hpp>

#include "subject.h"

struct Portable {
    template <class Raw, int F>
    static constexpr Raw multiply(Raw a, Raw b) {
        return fixedpoint::portable::multiply<Raw, F>(a, b);
    }
    template <class Raw, int F>
    static constexpr Raw divide(Raw a, Raw b) {
        return fixedpoint::portable::divide<Raw, F>(a, b);
    }
    template <class Raw, int F>
    static constexpr Raw sqrt(Raw a) {
        return fixedpoint::portable::sqrt<Raw, F>(a);
    }
};

// The 2016 design's idea for a better division: widen only where necessary.
struct Widening {
    template <class Raw, int F>
    static constexpr Raw divide(Raw a, Raw b) {
        return fixedpoint::portable::divide_widening<Raw, F>(a, b);
    }
};

IMPLEMENTATION_portable(SUBJECTS) IMPLEMENTATION_widening(SUBJECTS)
