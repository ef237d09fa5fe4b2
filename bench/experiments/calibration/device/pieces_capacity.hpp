// SPDX-License-Identifier: GPL-3.0-or-later
// How many pieces of a cubic the device program has room for.
#pragma once

constexpr unsigned pieces_capacity = 64;
