// SPDX-License-Identifier: GPL-3.0-or-later
// The portable C++ that the assembly kernels replace: what the compiler makes of the same results.
#include <fixedpoint/portable/divide.hpp>
#include <fixedpoint/portable/divide_widening.hpp>
#include <fixedpoint/portable/multiply.hpp>
#include <fixedpoint/portable/sqrt.hpp>

#include "subject.hpp"

#define PORTABLE(format, Raw, F)                             \
    SUBJECT Raw multiply_##format##_portable(Raw a, Raw b) { \
        return fixedpoint::portable::multiply<Raw, F>(a, b); \
    }                                                        \
    SUBJECT Raw divide_##format##_portable(Raw a, Raw b) {   \
        return fixedpoint::portable::divide<Raw, F>(a, b);   \
    }                                                        \
    SUBJECT Raw sqrt_##format##_portable(Raw a) { return fixedpoint::portable::sqrt<Raw, F>(a); }

PORTABLE(q4_4, int8_t, 4)
PORTABLE(q8_8, int16_t, 8)
PORTABLE(q16_16, int32_t, 16)
PORTABLE(q32_32, int64_t, 32)

// The report's own idea for a better division: widen only where it must.
SUBJECT int32_t divide_q16_16_widening(int32_t a, int32_t b) {
    return fixedpoint::portable::divide_widening<int32_t, 16>(a, b);
}
