// SPDX-License-Identifier: GPL-3.0-or-later
// A world of a description on the simulated chip: the programs of device/world.cpp.
#pragma once

#include <engine/error.hpp>
#include <filesystem>

#include "bench/chip/simulator/device_function.hpp"
#include "bench/experiments/stability/description.hpp"

namespace stability {

class ChipWorld {
  public:
    // Throws std::runtime_error if the program's step differs from the description's.
    ChipWorld(const std::filesystem::path& program, const Description& description);

    // Returns the cycles of the step, including its call (4) and return (4).
    std::uint32_t step() { return step_().cycles; }
    engine::Error error() { return static_cast<engine::Error>(error_().as<std::uint8_t>()); }
    std::uint32_t hash() { return hash_().as<std::uint32_t>(); }

  private:
    simulator::Chip chip_;
    simulator::DeviceFunction step_, error_, hash_;

    void call(const char* function, std::initializer_list<double> numbers, int a = 0, int b = 0);
};

}  // namespace stability
