// SPDX-License-Identifier: MIT
// How an assembly kernel takes the place of portable code on the device, and whether there are any.
#pragma once

#include <fixedpoint/integer.hpp>

// FIXEDPOINT_ASSEMBLY_KERNEL(Result, operation, Raw, F, symbol, twin, parameters, arguments): the
// dispatch `operation<Raw, F>` calls the assembly function `symbol`, and in constant expressions its
// portable twin, which has the same results.
//
// gnu_inline lets the function have a body for constant expressions that is never compiled into the
// program; noinline and noclone keep the compiler from using that body in calls at run time.
namespace fixedpoint {
namespace kernel {
#ifdef __AVR__
constexpr bool has_assembly = true;
#else
constexpr bool has_assembly = false;
#endif
}  // namespace kernel
}  // namespace fixedpoint

#ifdef __AVR__
#define FIXEDPOINT_ASSEMBLY_KERNEL(Result, operation, Raw, F, symbol, twin, parameters, arguments) \
    extern "C"                                                                                     \
        __attribute__((gnu_inline, noinline, noclone)) constexpr inline Result symbol parameters { \
        return ::fixedpoint::portable::twin<Raw, F> arguments;                                     \
    }                                                                                              \
    namespace fixedpoint {                                                                         \
    namespace kernel {                                                                             \
    template <>                                                                                    \
    constexpr Result operation<Raw, F> parameters {                                                \
        return symbol arguments;                                                                   \
    }                                                                                              \
    }                                                                                              \
    }
#else
#define FIXEDPOINT_ASSEMBLY_KERNEL(Result, operation, Raw, F, symbol, twin, parameters, arguments)
#endif
