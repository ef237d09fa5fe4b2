/* SPDX-License-Identifier: GPL-3.0-or-later
 * GCC's fixed-point types (ISO/IEC TR 18037): the toolchain's own fixed point, C only. */
#include <stdfix.h>

#include "bench/lab/catalogue/invoke.h"
#include "bench/lab/catalogue/subjects.h"

#define EXPRESSION_add a + b
#define EXPRESSION_subtract a - b
#define EXPRESSION_multiply a* b
#define EXPRESSION_divide a / b

#define SUBJECT_OF_OPERATION(name, signature, operands, results, kind, bound_ulp, domain, format, \
                             Type, F, operations)                                                 \
    Type name##_##format##_accum PARAMETERS_##signature(Type) { return EXPRESSION_##name; }
#define SUBJECTS_OF_FORMAT(format, Type, F, operations) \
    operations(SUBJECT_OF_OPERATION, format, Type, F, operations)
#define SUBJECTS(implementation, Policy, provenance, host, formats, operations, label) \
    formats(SUBJECTS_OF_FORMAT, operations)

IMPLEMENTATION_accum(SUBJECTS)
