/* SPDX-License-Identifier: GPL-3.0-or-later
 * avr-libc's fxlib, for GCC's _Accum: its functions in addition to the compiler's operators. */
#include <stdfix.h>

#include "adapter.h"

_Accum sqrtk(_Accum);
_Accum atank(_Accum);
_Accum asink(_Accum);
_Accum acosk(_Accum);
_Accum exp2k(_Accum);
_Accum log2uk(unsigned _Accum);
_Accum sinpi2k(_Accum);
_Accum cospi2k(_Accum);

/* The angle is in turns: an overflow drops whole turns. */
static _Accum quarter_turns(_Accum turns) {
    union {
        _Accum number;
        uint32_t bits;
    } angle = {turns};
    angle.bits <<= 2;
    return angle.number;
}

_Accum SUBJECT(sqrt, s16_15)(_Accum a) { return sqrtk(a); }
_Accum SUBJECT(atan, s16_15)(_Accum a) { return atank(a); }
_Accum SUBJECT(sin_turns, s16_15)(_Accum a) { return sinpi2k(quarter_turns(a)); }
_Accum SUBJECT(cos_turns, s16_15)(_Accum a) { return cospi2k(quarter_turns(a)); }
_Accum SUBJECT(asin, s16_15)(_Accum a) { return asink(a); }
_Accum SUBJECT(acos, s16_15)(_Accum a) { return acosk(a); }
_Accum SUBJECT(exp2, s16_15)(_Accum a) { return exp2k(a); }
/* The operand must be positive: its unsigned type has one more bit. */
_Accum SUBJECT(log2, s16_15)(_Accum a) { return log2uk(a); }
