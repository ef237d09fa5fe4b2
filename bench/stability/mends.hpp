// SPDX-License-Identifier: GPL-3.0-or-later
// What was mended in the published methods: each mend against the engine without that one mend, in
// limit, error and cycles.
#pragma once

#include <filesystem>

#include "bench/stability/search.hpp"

namespace stability {

// Writes mends.csv.
void measure_mends(const std::filesystem::path& output, const Effort& effort, unsigned threads);

}  // namespace stability
