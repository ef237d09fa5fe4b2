// SPDX-License-Identifier: GPL-3.0-or-later
// Functions whose symbols differ from their names.
#include <stdint.h>

namespace filter {
int16_t third(int16_t a) { return a / 3; }
int16_t twice(int16_t a) { return a * 2; }
int32_t twice(int32_t a) { return a * 2; }
}  // namespace filter
