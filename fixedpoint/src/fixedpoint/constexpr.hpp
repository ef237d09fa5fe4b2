// SPDX-License-Identifier: MIT
// FIXEDPOINT_CONSTEXPR: constexpr from C++14 on. C++11 allows a constant expression no more than a
// return statement; there, functions of several statements run when the program does, with the same
// results. Literals are constants in every standard.
#pragma once

#if __cplusplus >= 201402L
#define FIXEDPOINT_CONSTEXPR constexpr
#else
#define FIXEDPOINT_CONSTEXPR inline
#endif
