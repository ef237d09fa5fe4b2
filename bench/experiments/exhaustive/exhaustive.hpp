// SPDX-License-Identifier: GPL-3.0-or-later
// Judges the machine code of a device program over whole input spaces: functions of up to 32 bits
// of operands over every input, the others over a long search for the largest error and the most
// cycles. Bounds are `exact` where every input was run, for the bytes that are flashed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace machine_code {

// The `index`-th of `count` shares of a run, from 1 on.
struct Shard {
    unsigned index = 1;
    unsigned count = 1;
};

// Throws std::invalid_argument where the text is not i/n with 1 <= i <= n <= 256.
Shard parse_shard(const std::string& text);

struct Options {
    std::filesystem::path program;  // the device ELF, linked with --emit-relocs
    std::filesystem::path output;   // folder for exhaustive.csv, or for the files of a shard
    std::vector<std::string>
        symbols;  // <operation>_<format>_<implementation>; empty: all there are
    std::uint64_t search_operands =
        1'000'000'000;  // of a function of more than 32 bits of operands
    Shard shard;
    unsigned threads = 1;
};

// Writes exhaustive.csv, in which the rows of other functions stay, or, of a shard of many,
// exhaustive.<symbol>.<i>-of-<n>.json for each function. Returns how many results broke their
// definition or differ from the portable code's; each function's first is reported on stderr.
// Meanwhile exhaustive.<symbol>.<i>-of-<n>.checkpoint.json keep what is done: the same call after
// an interruption goes on from there, and writes the same bytes as a run without one. Throws
// std::invalid_argument where a symbol is none that can be judged, TranslationError, Misbehaviour.
std::uint64_t run_exhaustive(const Options& options);

// Joins the files of all shards, of one or more functions, into exhaustive.csv; the same file as a
// run without shards writes. Throws std::runtime_error where shards are missing, there twice, of
// different programs or of searches of different lengths.
std::uint64_t merge_exhaustive(const std::vector<std::filesystem::path>& shards,
                               const std::filesystem::path& output);

}  // namespace machine_code
