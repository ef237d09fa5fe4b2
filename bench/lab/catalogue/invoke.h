/* SPDX-License-Identifier: GPL-3.0-or-later
 * How an operation is called on the host and on the device, according to its signature:
 * invoke<operation, Policy, Raw, F>(...) calls the policy's function of that name, and a function
 * that does nothing else is
 *
 *     RESULT_binary(Raw) name PARAMETERS_binary(Raw) { return invoke<...> ARGUMENTS_binary; }
 *
 * A vector is passed as a pointer to its first component; several results are stored where the last
 * argument points.
 */
#ifndef BENCH_LAB_CATALOGUE_INVOKE_H
#define BENCH_LAB_CATALOGUE_INVOKE_H

#include "reference/operation_table.h"

/* clang-format off */
#define PARAMETERS_unary(Raw)     (Raw a)
#define PARAMETERS_binary(Raw)    (Raw a, Raw b)
#define PARAMETERS_ternary(Raw)   (Raw a, Raw b, Raw c)
#define PARAMETERS_pair(Raw)      (Raw a, Raw* results)
#define PARAMETERS_binary_pair(Raw) (Raw a, Raw b, Raw* results)
#define PARAMETERS_dot(Raw)       (const Raw* a, const Raw* b)
#define PARAMETERS_length(Raw)    (const Raw* a)
#define PARAMETERS_direction(Raw) (const Raw* a, Raw* results)

#define ARGUMENTS_unary     (a)
#define ARGUMENTS_binary    (a, b)
#define ARGUMENTS_ternary   (a, b, c)
#define ARGUMENTS_pair      (a, results)
#define ARGUMENTS_binary_pair (a, b, results)
#define ARGUMENTS_dot       (a, b)
#define ARGUMENTS_length    (a)
#define ARGUMENTS_direction (a, results)

#define RESULT_unary(Raw)     Raw
#define RESULT_binary(Raw)    Raw
#define RESULT_ternary(Raw)   Raw
#define RESULT_pair(Raw)      void
#define RESULT_binary_pair(Raw) void
#define RESULT_dot(Raw)       Raw
#define RESULT_length(Raw)    Raw
#define RESULT_direction(Raw) void
/* clang-format on */

#ifdef __cplusplus
namespace catalogue {

template <reference::Operation operation>
struct Invocation;

#define INVOCATION(name, ...)                                                               \
    template <>                                                                             \
    struct Invocation<reference::Operation::name> {                                         \
        template <class Policy, class Raw, int F, class... Arguments>                       \
        __attribute__((always_inline)) static constexpr auto call(Arguments... arguments) { \
            return Policy::template name<Raw, F>(arguments...);                             \
        }                                                                                   \
    };
OPERATIONS(INVOCATION)
#undef INVOCATION

template <reference::Operation operation, class Policy, class Raw, int F, class... Arguments>
__attribute__((always_inline)) constexpr auto invoke(Arguments... arguments) {
    return Invocation<operation>::template call<Policy, Raw, F>(arguments...);
}

}  // namespace catalogue
#endif

#endif
