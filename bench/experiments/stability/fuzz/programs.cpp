// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer: ELF files of programs for the chip, read and run briefly.
#include "bench/chip/simulator/chip.hpp"
#include "bench/experiments/stability/fuzz/refusal.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto path = fuzz::file("program.elf", {reinterpret_cast<const char*>(data), size});
    fuzz::takes([&] {
        const simulator::Elf elf(path);
        fuzz::check(!elf.flash().empty() && elf.flash().size() <= simulator::Elf::flash_size,
                    "more than the flash holds");
        elf.flash_bytes();
        elf.describe(0);
        for (const auto& [name, symbol] : elf.functions())
            fuzz::check(symbol.address + symbol.size <= elf.flash().size(),
                        "a function outside of the flash");
        fuzz::takes([&] { simulator::Chip(elf).run_until_cycle(10000); });
        fuzz::takes([&] { elf.function("no such function"); });
    });
    return 0;
}
