// SPDX-License-Identifier: GPL-3.0-or-later
// The number of pieces of a cubic for which the device program has room.
#pragma once

constexpr unsigned pieces_capacity = 64;
