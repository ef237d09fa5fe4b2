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

// FIXEDPOINT_IN_PLACE: the same of a function whose result of several bytes its caller takes apart,
// which would pass through memory if it was called.
#ifdef __GNUC__
#define FIXEDPOINT_IN_PLACE FIXEDPOINT_CONSTEXPR __attribute__((always_inline))
#else
#define FIXEDPOINT_IN_PLACE FIXEDPOINT_CONSTEXPR
#endif
