// SPDX-License-Identifier: GPL-3.0-or-later
// Any chip that simavr knows, for calls of functions only. No peripheral runs and no interrupt
// occurs; the cycles of instructions need none of the ATmega328P's workarounds (chip.hpp).
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "bench/chip/simulator/convention.hpp"

struct avr_t;

namespace simulator {

class OtherChip {
  public:
    // Loads the program and runs it up to main(). Throws SimulationError if simavr does not know
    // the chip, or if the file is not a program for it.
    OtherChip(const std::string& name, const std::filesystem::path& program);
    ~OtherChip();
    OtherChip(const OtherChip&) = delete;
    OtherChip& operator=(const OtherChip&) = delete;

    struct Outcome {
        std::uint64_t result;
        std::uint32_t cycles;  // including the chip's own call and ret
    };
    // Throws SimulationError if the function does not exist, does not return, or breaks the calling
    // convention.
    Outcome call(const std::string& function, const Signature& signature,
                 std::span<const std::uint64_t> operands);

    // Reserves SRAM above the program's variables, for operands that functions take by address.
    std::uint16_t allocate(std::size_t bytes);
    std::uint8_t* data() const { return data_; }

  private:
    void run_to(std::uint32_t address, std::uint64_t budget, std::string_view what);

    avr_t* avr_;
    std::uint8_t* data_;
    std::map<std::string, std::uint32_t, std::less<>> symbols_;
    std::uint16_t free_ = 0;
};

}  // namespace simulator
