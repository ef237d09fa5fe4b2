/* SPDX-License-Identifier: GPL-3.0-or-later
 * A subject is a function of the device program that the bench calls and judges by itself:
 * extern "C" <operation>_<format>_<implementation>. SUBJECTS defines those of a row of
 * bench/lab/catalogue/subjects.h, in all its formats or, with IN_FORMAT, in one.
 *
 * Subjects are weak, so that the linker can put an assembly kernel in the place of the C++ function
 * that would only jump to it (link_subjects.py). */
#pragma once

#include <stdint.h>

#include "bench/lab/catalogue/invoke.h"
#include "bench/lab/catalogue/subjects.h"

#define SUBJECT extern "C" __attribute__((weak))

#define SUBJECT_OF_OPERATION(name, signature, operands, results, kind, bound_ulp, domain, format, \
                             Raw, F, implementation, Policy)                                      \
    SUBJECT RESULT_##signature(Raw)                                                               \
        name##_##format##_##implementation PARAMETERS_##signature(Raw) {                          \
        return catalogue::invoke<reference::Operation::name, Policy, Raw, F>                      \
            ARGUMENTS_##signature;                                                                \
    }
#define SUBJECTS_OF_FORMAT(format, Raw, F, implementation, Policy, operations) \
    operations(SUBJECT_OF_OPERATION, format, Raw, F, implementation, Policy)
#define SUBJECTS(implementation, Policy, provenance, host, formats, operations, label) \
    formats(SUBJECTS_OF_FORMAT, implementation, Policy, operations)
#define SUBJECTS_IN_FORMAT(implementation, Policy, provenance, host, formats, operations, label) \
    LIBRARY_FORMAT(SUBJECTS_OF_FORMAT, implementation, Policy, operations)
