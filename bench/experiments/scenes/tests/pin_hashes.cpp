// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the file of pinned hashes: pin_scene_hashes
// bench/experiments/scenes/tests/pinned_hashes.csv
#include <cstdio>
#include <cstdlib>
#include <exception>

#include "bench/experiments/scenes/tests/pinned_hashes.hpp"

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: pin_scene_hashes <file to write>\n", stderr);
        return EXIT_FAILURE;
    }
    try {
        scene_bench::hash_scenes().save(argv[1]);
        return EXIT_SUCCESS;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "pin_scene_hashes: %s\n", error.what());
        return EXIT_FAILURE;
    }
}
