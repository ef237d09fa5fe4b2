// SPDX-License-Identifier: GPL-3.0-or-later
// The operands with which the rebuilt timing harness fits the published table best, as found by
// `fixbench table`. Operations of more than two operands repeat them in turn.
#pragma once

#include <array>
#include <cstdint>

namespace operands {

// For formats other than float, as raws. Narrower formats keep the low bits, as an assignment
// would.
inline constexpr std::array<std::int64_t, 2> published_raws = {1000000, 3};
inline constexpr std::array<float, 2> published_floats = {3.75f, 1.25f};

}  // namespace operands
