/* SPDX-License-Identifier: GPL-3.0-or-later
 * What the libraries for Arduino use of its core: the names and limits of the integers. */
#pragma once

#include <limits.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

typedef uint8_t byte;
#ifdef __cplusplus
long random(long most);
long random(long least, long most);
#endif
