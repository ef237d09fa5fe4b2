// SPDX-License-Identifier: MIT
// FIXEDPOINT_CONSTEXPR: constexpr from C++14 on. In C++11 a constexpr function must be a single
// return statement; functions of several statements are therefore evaluated at run time there, with
// the same results. Literals are constants in every standard.
#pragma once

#if __cplusplus >= 201402L
#define FIXEDPOINT_CONSTEXPR constexpr
#else
#define FIXEDPOINT_CONSTEXPR inline
#endif

// FIXEDPOINT_IN_PLACE: the same, always inlined. For a function that returns several values
// together, which would pass through memory in an actual call.
#ifdef __GNUC__
#define FIXEDPOINT_IN_PLACE FIXEDPOINT_CONSTEXPR __attribute__((always_inline))
#else
#define FIXEDPOINT_IN_PLACE FIXEDPOINT_CONSTEXPR
#endif
