// SPDX-License-Identifier: MIT
// Calls the operation of every row of the table of kernels once. Compiled for a chip with kernels,
// the object has the symbol of each row undefined and does not contain portable code.
#include <fixedpoint/kernel/nearest.hpp>

using namespace fixedpoint;

#define CALL(shape, operation, Raw, F, symbol, implementation)                        \
    FIXEDPOINT_RESULT_##shape(Raw) call_##symbol FIXEDPOINT_PARAMETERS_##shape(Raw);  \
    FIXEDPOINT_RESULT_##shape(Raw) call_##symbol FIXEDPOINT_PARAMETERS_##shape(Raw) { \
        return kernel::operation<Raw, F> FIXEDPOINT_ARGUMENTS_##shape;                \
    }
FIXEDPOINT_KERNELS(CALL)
FIXEDPOINT_ROUNDED_KERNELS(CALL)
FIXEDPOINT_ROUNDED_ANGLE_KERNELS(CALL)
FIXEDPOINT_SIDE_KERNELS(CALL)
