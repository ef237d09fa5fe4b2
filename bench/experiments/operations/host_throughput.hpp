// SPDX-License-Identifier: GPL-3.0-or-later
// The cost of the portable code on the host, by Google Benchmark.
#pragma once

#include <filesystem>

namespace operations {

// Runs each function for that many seconds and writes Google Benchmark's JSON.
void measure_throughput(const std::filesystem::path& file, double seconds);

}  // namespace operations
