// SPDX-License-Identifier: GPL-3.0-or-later
// Results in Google Benchmark's JSON schema, so that its compare.py reads simulated and host
// figures alike.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace records {

// One benchmark of the simulated chip: at 16 MHz one cycle is 62.5 ns.
struct SimulatedBenchmark {
    std::string name;
    std::uint64_t iterations;
    double cycles_mean;
    nlohmann::json counters;  // further numbers by name, merged into the entry
};

// The document of a simulated run. `context` is merged into the schema's context object. There is
// no date in it: equal measurements give equal files.
nlohmann::json benchmark_document(const std::vector<SimulatedBenchmark>& benchmarks,
                                  const nlohmann::json& context);

}  // namespace records
