// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/haptic/recording.hpp"

#include <fmt/format.h>

#include "bench/lab/records/whole_file.hpp"

namespace haptic {
namespace {

constexpr int cycle_in_units = 625;
constexpr const char* names[] = {"step",        "render",    "collision",
                                 "square_root", "operation", "servo"};
char identifier(int pin) { return static_cast<char>('a' + pin); }

}  // namespace

std::string value_change_dump(const std::vector<PinEdge>& edges) {
    std::string text = "$timescale 100 ps $end\n$scope module atmega328p $end\n";
    for (int pin = DeviceLoop::first_pin; pin <= DeviceLoop::last_pin; ++pin)
        text += fmt::format("$var wire 1 {} PD{}_{} $end\n", identifier(pin), pin,
                            names[pin - DeviceLoop::first_pin]);
    text += "$upscope $end\n$enddefinitions $end\n$dumpvars\n";
    for (int pin = DeviceLoop::first_pin; pin <= DeviceLoop::last_pin; ++pin)
        text += fmt::format("0{}\n", identifier(pin));
    text += "$end\n";
    Cycle last = 0;
    for (const PinEdge& edge : edges) {
        if (edge.at != last) text += fmt::format("#{}\n", edge.at * cycle_in_units);
        last = edge.at;
        text += fmt::format("{}{}\n", edge.level ? 1 : 0, identifier(edge.pin));
    }
    return text;
}

Recording::Recording(DeviceLoop& loop)
    : table_({"time_s", "lever_deg", "servo_deg", "servo_target_deg", "pulse_us", "force_n",
              "hand_force_n", "sensor_a", "sensor_b", "arm_m"}) {
    loop.record_edges(edges_);
}

void Recording::watch(DeviceLoop& loop) {
    const Plant& plant = loop.plant();
    const auto in_degrees = [](double angle) { return records::cell(angle / degrees(1)); };
    table_.add({records::cell(loop.time()), in_degrees(plant.lever_angle()),
                in_degrees(plant.servo_angle()), in_degrees(plant.servo_target()),
                records::cell(loop.pulse() * 1e6),
                records::cell(plant.sensor_force(0) - plant.sensor_force(1)),
                records::cell(plant.hand_force()), records::cell(plant.sensor_reading(0)),
                records::cell(plant.sensor_reading(1)), records::cell(loop.arm_length())});
    if (loop.screen() == last_screen_) return;
    last_screen_ = loop.screen();
    screens_ += fmt::format("{:.3f}\n", loop.time());
    for (const std::string& line : last_screen_) screens_ += line + '\n';
}

void Recording::save(const std::filesystem::path& folder, const std::string& name) const {
    table_.save(folder / (name + ".csv"));
    records::write_whole(folder / (name + ".vcd"), value_change_dump(edges_));
    records::write_whole(folder / (name + ".screen.txt"), screens_);
}

}  // namespace haptic
