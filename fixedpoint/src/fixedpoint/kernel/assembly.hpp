// SPDX-License-Identifier: MIT
// Whether the assembly kernels of avr/ are used, and how a kernel replaces portable code.
//
// They need an AVR with a hardware multiplier; FIXEDPOINT_NO_ASSEMBLY turns them off. A program
// that must not be built without them defines FIXEDPOINT_ASSEMBLY.
#pragma once

#include <fixedpoint/constexpr.hpp>

namespace fixedpoint {
namespace kernel {
#if defined(__AVR__) && defined(__AVR_HAVE_MUL__) && !defined(FIXEDPOINT_NO_ASSEMBLY)
constexpr bool has_assembly = true;
#define FIXEDPOINT_DISPATCH FIXEDPOINT_DISPATCH_TO_KERNEL
#define FIXEDPOINT_CALLED_BY_KERNEL __attribute__((used, noinline))
#else
constexpr bool has_assembly = false;
#define FIXEDPOINT_DISPATCH(shape, operation, Raw, F, symbol, implementation)
#define FIXEDPOINT_CALLED_BY_KERNEL __attribute__((noinline))
#endif

// FIXEDPOINT_CALLED_BY_KERNEL marks a function template that kernels jump to or call. The caller of
// such a kernel must evaluate is_kept(function), which instantiates the function and is always
// true; otherwise the program does not link.
template <class Function>
constexpr bool is_kept(Function*) {
    return true;
}
}  // namespace kernel
}  // namespace fixedpoint

#ifdef FIXEDPOINT_ASSEMBLY
static_assert(
    fixedpoint::kernel::has_assembly,
    "FIXEDPOINT_ASSEMBLY asks for the assembly kernels, which need an AVR with a hardware "
    "multiplier and exclude FIXEDPOINT_NO_ASSEMBLY.");
#endif

// FIXEDPOINT_DISPATCH(shape, operation, Raw, F, symbol, implementation), a row of kernel/table.hpp,
// makes kernel::operation<Raw, F> call `symbol` at run time, and portable::implementation<Raw, F>
// in constant expressions. How the two cases are distinguished depends on the compiler:
//
// GCC from 9 and clang from 9 have __builtin_is_constant_evaluated.
//
// GCC 5 to 7 do not. Their gnu_inline gives `symbol` a body for constant expressions that is never
// compiled into the program. noinline and noclone keep the optimiser from using it at run time. A
// section of its own keeps the optimiser from merging it with another symbol that has the same body
// (sqrt and sqrt_small), which no_icf does not prevent.
//
// GCC 8 rejects that combination of attributes, and C++11 does not allow such constant expressions.
// There, only the call remains, and what would be a constant is computed at run time.
#if __cplusplus < 201402L || (__GNUC__ == 8 && !defined(__clang__))
#define FIXEDPOINT_DECLARE_KERNEL(shape, Raw, F, symbol, implementation) \
    FIXEDPOINT_RESULT_##shape(Raw) symbol FIXEDPOINT_PARAMETERS_##shape(Raw);
#define FIXEDPOINT_CALL_KERNEL(shape, Raw, F, symbol, implementation) \
    symbol FIXEDPOINT_ARGUMENTS_##shape
#define FIXEDPOINT_KERNEL_CONSTEXPR inline
#elif __GNUC__ >= 9 || defined(__clang__)
#define FIXEDPOINT_DECLARE_KERNEL(shape, Raw, F, symbol, implementation) \
    FIXEDPOINT_RESULT_##shape(Raw) symbol FIXEDPOINT_PARAMETERS_##shape(Raw);
#define FIXEDPOINT_CALL_KERNEL(shape, Raw, F, symbol, implementation)                  \
    __builtin_is_constant_evaluated() ? ::fixedpoint::portable::implementation<Raw, F> \
                                            FIXEDPOINT_ARGUMENTS_##shape               \
                                      : symbol FIXEDPOINT_ARGUMENTS_##shape
#define FIXEDPOINT_KERNEL_CONSTEXPR constexpr
#else
#define FIXEDPOINT_DECLARE_KERNEL(shape, Raw, F, symbol, implementation)                    \
    __attribute__((                                                                         \
        gnu_inline, noinline, noclone,                                                      \
        section(".discarded." #symbol))) constexpr inline FIXEDPOINT_RESULT_##shape(Raw)    \
        symbol FIXEDPOINT_PARAMETERS_##shape(Raw) {                                         \
        return ::fixedpoint::portable::implementation<Raw, F> FIXEDPOINT_ARGUMENTS_##shape; \
    }
#define FIXEDPOINT_CALL_KERNEL(shape, Raw, F, symbol, implementation) \
    symbol FIXEDPOINT_ARGUMENTS_##shape
#define FIXEDPOINT_KERNEL_CONSTEXPR constexpr
#endif

#define FIXEDPOINT_DISPATCH_TO_KERNEL(shape, operation, Raw, F, symbol, implementation) \
    extern "C" {                                                                        \
    FIXEDPOINT_DECLARE_KERNEL(shape, Raw, F, symbol, implementation)                    \
    }                                                                                   \
    namespace fixedpoint {                                                              \
    namespace kernel {                                                                  \
    template <>                                                                         \
    FIXEDPOINT_KERNEL_CONSTEXPR FIXEDPOINT_RESULT_##shape(                              \
        Raw) operation<Raw, F> FIXEDPOINT_PARAMETERS_##shape(Raw) {                     \
        return FIXEDPOINT_CALL_KERNEL(shape, Raw, F, symbol, implementation);           \
    }                                                                                   \
    }                                                                                   \
    }
