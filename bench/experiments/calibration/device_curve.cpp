// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/calibration/device_curve.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sim_avr.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "bench/chip/simulator/device_function.hpp"
#include "bench/experiments/calibration/device/pieces_capacity.hpp"
#include "bench/lab/records/csv.hpp"

namespace calibration {
namespace {

using firmware::calibration::CubicPiece;
using fixedpoint::Q16_16;

static_assert(sizeof(CubicPiece) == 20, "The chip has no padding.");

// The nearest multiple of 2^-16.
std::int32_t quantised(double coefficient) {
    const double raw = std::floor(coefficient * 65536 + 0.5);
    if (!(std::abs(raw) < 2147483648.0))
        throw std::runtime_error(fmt::format("{:g} does not fit 16:16 bits", coefficient));
    return static_cast<std::int32_t>(raw);
}

std::vector<CubicPiece> pieces_of(const Curve& curve) {
    std::vector<CubicPiece> pieces;
    if (curve.family != Family::monotone_cubic) return pieces;
    const std::vector<double>& c = curve.coefficients;
    const auto piece = [](double first, double width, double value, double slope, double square,
                          double cube) {
        const auto bits = [](double x) { return static_cast<std::uint32_t>(quantised(x)); };
        return CubicPiece{static_cast<std::uint16_t>(first),
                          static_cast<std::uint16_t>(width),
                          bits(value),
                          bits(slope),
                          bits(square),
                          bits(cube)};
    };
    for (std::size_t i = 0; i + 3 < c.size(); i += 3) {
        const double width = c[i + 3] - c[i], rise = c[i + 4] - c[i + 1];
        const double slope = c[i + 2] * width, next_slope = c[i + 5] * width;
        pieces.push_back(piece(c[i], width, c[i + 1], slope, 3 * rise - 2 * slope - next_slope,
                               slope + next_slope - 2 * rise));
    }
    const std::size_t last = c.size() - 3;
    pieces.push_back(piece(c[last], 1, c[last + 1], c[last + 2], 0, 0));
    return pieces;
}

std::string type_name(Family family) {
    switch (family) {
        case Family::line:
            return "Line";
        case Family::rational_quadratic:
            return "RationalQuadratic";
        case Family::quadratic:
            return "Quadratic";
        case Family::hyperbola:
            return "Hyperbola";
        case Family::conductance_power:
            return "ConductancePower";
        case Family::monotone_cubic:
            return "MonotoneCubic";
    }
    throw std::logic_error("a family without a type");
}

int footprint(const std::filesystem::path& file, const std::string& subject) {
    const records::Table table = records::Table::load(file);
    const std::size_t name = table.column("subject"), flash = table.column("flash_bytes");
    for (const auto& row : table.rows()) {
        if (row[name] == subject) return std::stoi(row[flash]);
    }
    throw std::runtime_error(fmt::format("{}: no subject {}", file.string(), subject));
}

}  // namespace

DeviceCurve::DeviceCurve(const Curve& curve, Range range)
    : family_(curve.family), pieces_(pieces_of(curve)) {
    using namespace firmware::calibration;
    const std::vector<double>& c = curve.coefficients;
    const auto q = quantised;
    const auto lowest = static_cast<std::int16_t>(range.lowest);
    const auto highest = static_cast<std::int16_t>(range.highest);
    switch (family_) {
        case Family::line:
            curve_ = Held<Line>{lowest, highest, {q(c[0] * 0x1p10), q(c[1])}};
            break;
        case Family::rational_quadratic:
            curve_ = Held<RationalQuadratic>{
                lowest, highest, {q(c[0] * 0x1p25), q(c[1] * 0x1p15), q(c[2] * 32)}};
            break;
        case Family::quadratic:
            curve_ =
                Held<Quadratic>{lowest, highest, {q(c[0] * 0x1p20), q(c[1] * 0x1p10), q(c[2])}};
            break;
        case Family::hyperbola:
            quantised(c[2] * 16);  // throws if too large: up to 16 readings are summed
            curve_ =
                Held<Hyperbola>{lowest, highest, {q(c[0] - c[1]), q(c[1] * c[2] / 4), q(c[2])}};
            break;
        case Family::conductance_power:
            curve_ = Held<ConductancePower>{lowest, highest, {q(c[0]), q(c[1]), q(c[2])}};
            break;
        case Family::monotone_cubic:
            curve_ = Held<MonotoneCubic>{
                lowest, highest, {pieces_.data(), static_cast<int16_t>(pieces_.size())}};
            break;
    }
}

std::int32_t DeviceCurve::raw(int reading) const {
    return std::visit(
        [&](const auto& curve) { return curve.template grams<Q16_16>(reading).raw(); }, curve_);
}

DeviceMeasurement DeviceCurve::measure(const DeviceProgram& program) const {
    const std::string symbol = name_of(family_) + "_q16_16_default";
    simulator::Chip chip{simulator::Elf(program.elf)};
    chip.run_until_function("main");
    std::vector<std::uint64_t> operands;
    if (family_ == Family::monotone_cubic) {
        // The table is in flash, at an address that the program reserves.
        simulator::DeviceFunction place(chip, "pieces_q16_16_default", {2, {}});
        const std::uint16_t address = place().as<std::uint16_t>();
        if (pieces_.size() > pieces_capacity)
            throw std::runtime_error(fmt::format("{} pieces; the device program has room for {}",
                                                 pieces_.size(), pieces_capacity));
        std::memcpy(chip.core()->flash + address, pieces_.data(),
                    pieces_.size() * sizeof(CubicPiece));
        const auto& held = std::get<Held<firmware::calibration::MonotoneCubic>>(curve_);
        operands = {address, pieces_.size(), static_cast<std::uint64_t>(held.lowest),
                    static_cast<std::uint64_t>(held.highest), 0};
    } else {
        std::visit(
            [&](const auto& curve) {
                const std::uint16_t address = chip.allocate(sizeof curve);
                std::vector<std::uint8_t> bytes(sizeof curve);
                std::memcpy(bytes.data(), &curve, bytes.size());
                chip.write(address, bytes);
                operands = {address, 0};
            },
            curve_);
    }
    simulator::DeviceFunction grams(
        chip, symbol, {.result = 4, .operands = std::vector<int>(operands.size(), 2)});
    DeviceMeasurement measurement{{}, 0, 0, 0, footprint(program.footprints, symbol)};
    if (family_ == Family::monotone_cubic)
        measurement.flash_bytes += static_cast<int>(pieces_.size() * sizeof(CubicPiece));
    for (int reading = 0; reading < 1024; ++reading) {
        operands.back() = static_cast<std::uint64_t>(reading);
        const simulator::Outcome outcome = grams.call(operands);
        const std::int32_t result = outcome.as<std::int32_t>();
        if (result != raw(reading))
            throw std::logic_error(fmt::format("{} of reading {} is {} on the chip, {} here",
                                               symbol, reading, result, raw(reading)));
        measurement.raw[static_cast<std::size_t>(reading)] = result;
        measurement.cycles_mean += outcome.cycles / 1024.0;
        measurement.cycles_max = std::max<double>(measurement.cycles_max, outcome.cycles);
        measurement.stack_bytes = std::max<int>(measurement.stack_bytes, outcome.stack_bytes);
    }
    return measurement;
}

std::string DeviceCurve::definition() const {
    return std::visit(
        [&](const auto& held) {
            using Held = std::decay_t<decltype(held)>;
            const std::string type = type_name(family_);
            if constexpr (std::is_same_v<Held,
                                         DeviceCurve::Held<firmware::calibration::MonotoneCubic>>) {
                std::string text =
                    "static const CubicPiece pieces[] FIXEDPOINT_PROGRAM_MEMORY = {\n";
                for (const CubicPiece& p : pieces_)
                    text += fmt::format("    {{{}, {}, {}u, {}u, {}u, {}u}},\n", p.first, p.width,
                                        p.value, p.slope, p.square, p.cube);
                return text + fmt::format(
                                  "}};\nconstexpr Held<{}> curve = {{{}, {}, {{pieces, "
                                  "{}}}}};\n",
                                  type, held.lowest, held.highest, pieces_.size());
            } else {
                // The members of such a curve are its coefficients and nothing else.
                std::array<std::int32_t, sizeof held.curve / sizeof(std::int32_t)> c;
                static_assert(sizeof c == sizeof held.curve);
                std::memcpy(c.data(), &held.curve, sizeof c);
                return fmt::format("constexpr Held<{}> curve = {{{}, {}, {{{}}}}};\n", type,
                                   held.lowest, held.highest, fmt::join(c, ", "));
            }
        },
        curve_);
}

}  // namespace calibration
