// SPDX-License-Identifier: GPL-3.0-or-later
// Judges the machine code of a device program. Runs a function of up to 32 operand bits on every
// input, and searches the others for the largest error and the most cycles. A bound is `exact` if
// every input was run, for the bytes that are flashed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace machine_code {

// Share number `index` of `count` shares of a run, from 1.
struct Shard {
    unsigned index = 1;
    unsigned count = 1;
};

// Throws std::invalid_argument unless the text is i/n with 1 <= i <= n <= 256.
Shard parse_shard(const std::string& text);

struct Options {
    std::filesystem::path program;     // the device ELF, linked with --emit-relocs
    std::filesystem::path output;      // folder for exhaustive.csv, or for the files of a shard
    std::vector<std::string> symbols;  // <operation>_<format>_<implementation>; empty: all
    std::uint64_t search_operands =
        1'000'000'000;  // for a function of more than 32 bits of operands
    Shard shard;
    unsigned threads = 1;
};

// Writes exhaustive.csv, keeping the rows of other functions, or, for one shard of many,
// exhaustive.<symbol>.<i>-of-<n>.json for each function. Returns how many results contradict their
// definition or differ from the portable code's; the first of each function is reported on stderr.
// During the run, exhaustive.<symbol>.<i>-of-<n>.checkpoint.json contain the parts that are done:
// after an interruption the same call continues from there and writes the same bytes as a run
// without one. Throws std::invalid_argument for a symbol that cannot be judged, TranslationError or
// Misbehaviour.
std::uint64_t run_exhaustive(const Options& options);

// Joins the files of all shards, of one or more functions, into exhaustive.csv, the same file that
// a run without shards writes. Throws std::runtime_error if shards are missing, occur twice, or
// belong to different programs or to searches of different lengths.
std::uint64_t merge_exhaustive(const std::vector<std::filesystem::path>& shards,
                               const std::filesystem::path& output);

}  // namespace machine_code
