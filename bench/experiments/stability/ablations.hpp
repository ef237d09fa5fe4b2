// SPDX-License-Identifier: GPL-3.0-or-later
// The improvements over the published methods: each ablation compared with the complete engine, in
// limit, error and cycles.
#pragma once

#include <filesystem>

#include "bench/experiments/stability/search.hpp"

namespace stability {

// Writes ablations.csv.
void measure_ablations(const std::filesystem::path& output, const Effort& effort, unsigned threads);

}  // namespace stability
