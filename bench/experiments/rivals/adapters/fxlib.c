/* SPDX-License-Identifier: GPL-3.0-or-later
 * avr-libc's fxlib, for GCC's _Accum: what it adds to the compiler's operators. */
#include <stdfix.h>

#include "adapter.h"

_Accum sqrtk(_Accum);
_Accum atank(_Accum);

_Accum SUBJECT(sqrt, s16_15)(_Accum a) { return sqrtk(a); }
_Accum SUBJECT(atan, s16_15)(_Accum a) { return atank(a); }
