// SPDX-License-Identifier: GPL-3.0-or-later
// A simulated Nano to flash and to talk to. Prints the name of its serial port and runs until it is
// interrupted.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>

#include "bench/chip/bootloader/board.hpp"
#include "this_build.hpp"

namespace {
volatile std::sig_atomic_t interrupted = 0;
}

int main(int argc, char** argv) {
    CLI::App app("A simulated Nano with its bootloader, on a serial port that this program prints");
    bool old = false;
    app.add_flag("--old-bootloader", old, "57600 baud and 2 KB, as on Nanos before 2018");
    app.footer("Example: virtual_board & scripts/flash.sh --port PORT");
    CLI11_PARSE(app, argc, argv);
    try {
        bootloader::Board board(
            build_folder() / "bench/chip/bootloader" / (old ? "atmegaboot.elf" : "optiboot.elf"),
            false);
        for (const int signal : {SIGINT, SIGTERM})
            std::signal(signal, [](int) { interrupted = 1; });
        fmt::print("{}\n", board.port());
        std::fflush(stdout);
        while (!interrupted) board.serve();
    } catch (const std::exception& error) {
        fmt::print(stderr, "virtual_board: {}\n", error.what());
        return 1;
    }
}
