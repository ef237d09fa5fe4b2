// SPDX-License-Identifier: GPL-3.0-or-later
// Runs a test program of fixedpoint/tests/device on any chip that simavr knows, and prints its
// counts. Cycles mean nothing here: the workarounds that make them exact are those of the
// ATmega328P (bench/chip/simulator).
//
// Usage: run_on_chip MCU ELF FINISHED CHECKS FAILURES LINE
// The last four are addresses, in hexadecimal as printed by avr-nm.
#include <sim_avr.h>
#include <sim_elf.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace {

constexpr std::uint64_t budget = 160'000'000;  // cycles

std::uint32_t address(const char* text) {
    return static_cast<std::uint32_t>(std::strtoul(text, nullptr, 16));
}

unsigned word(const avr_t& avr, const char* symbol) {
    const std::uint32_t at = address(symbol) & 0xffff;  // avr-nm adds 0x800000 to those of RAM
    return avr.data[at] | avr.data[at + 1] << 8;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 7) {
        std::fprintf(stderr, "run_on_chip: expects MCU ELF FINISHED CHECKS FAILURES LINE\n");
        return 2;
    }
    elf_firmware_t firmware = {};
    avr_t* const avr = avr_make_mcu_by_name(argv[1]);
    if (avr == nullptr || elf_read_firmware(argv[2], &firmware) != 0) {
        std::fprintf(stderr, "run_on_chip: no chip '%s', or no program '%s'\n", argv[1], argv[2]);
        return 2;
    }
    avr_init(avr);
    avr->frequency = 16'000'000;
    avr_load_firmware(avr, &firmware);

    const std::uint32_t finished = address(argv[3]);
    while (avr->pc != finished) {
        const int state = avr_run(avr);
        if (state == cpu_Crashed || state == cpu_Done || avr->cycle > budget) {
            std::fprintf(stderr, "run_on_chip: %s does not end on the %s\n", argv[2], argv[1]);
            return 1;
        }
    }
    const unsigned checks = word(*avr, argv[4]), failures = word(*avr, argv[5]);
    std::printf("%u checks, %u failures", checks, failures);
    if (failures != 0) std::printf(", the first one in line %u", word(*avr, argv[6]));
    std::printf("\n");
    return checks != 0 && failures == 0 ? 0 : 1;
}
