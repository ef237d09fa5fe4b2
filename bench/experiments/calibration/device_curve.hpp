// SPDX-License-Identifier: GPL-3.0-or-later
// A fitted curve as the firmware evaluates it: coefficients in units of 2^-16, arithmetic in
// Q16.16.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <firmware/calibration_curves.hpp>
#include <string>
#include <variant>
#include <vector>

#include "bench/experiments/calibration/curve.hpp"
#include "this_build.hpp"

namespace calibration {

struct DeviceProgram {
    std::filesystem::path elf =
        build_folder() / "bench/experiments/calibration/calibration_curves.elf";
    std::filesystem::path footprints =
        std::filesystem::path(elf).replace_extension("footprints.csv");
};

// Over all 1024 readings, on the simulated chip.
struct DeviceMeasurement {
    std::array<std::int32_t, 1024> raw;
    double cycles_mean, cycles_max;
    int stack_bytes, flash_bytes;
};

class DeviceCurve {
  public:
    // Throws std::runtime_error if a scaled coefficient does not fit 16:16 bits.
    DeviceCurve(const Curve& curve, Range range);
    // Not copied: there are pointers to the pieces of a cubic.
    DeviceCurve(const DeviceCurve&) = delete;
    DeviceCurve& operator=(const DeviceCurve&) = delete;

    // In Q16.16 on the host, bit for bit equal to the chip's result.
    std::int32_t raw(int reading) const;

    // Throws std::logic_error if the chip returns anything other than `raw`.
    DeviceMeasurement measure(const DeviceProgram& program) const;

    // The definitions of the curve for calibration_table.hpp.
    std::string definition() const;

  private:
    template <class T>
    using Held = firmware::calibration::Held<T>;

    Family family_;
    std::vector<firmware::calibration::CubicPiece> pieces_;
    std::variant<Held<firmware::calibration::Line>, Held<firmware::calibration::RationalQuadratic>,
                 Held<firmware::calibration::Quadratic>, Held<firmware::calibration::Hyperbola>,
                 Held<firmware::calibration::ConductancePower>,
                 Held<firmware::calibration::MonotoneCubic>>
        curve_;
};

}  // namespace calibration
