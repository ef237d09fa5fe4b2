/* SPDX-License-Identifier: GPL-3.0-or-later
 * SUBJECT(sqrt, q16_16) is the name of the function that the bench calls; RIVAL is the name of the
 * rival, from the command line. */
#pragma once

#include <stdint.h>

#define SUBJECT_OF(operation, format, rival) operation##_##format##_##rival
#define SUBJECT_OF_RIVAL(operation, format, rival) SUBJECT_OF(operation, format, rival)
#define SUBJECT(operation, format) SUBJECT_OF_RIVAL(operation, format, RIVAL)
