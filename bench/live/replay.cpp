// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/live/replay.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace live {
namespace {

using haptic::degrees;
using nlohmann::ordered_json;

double rounded(double value, double places) { return std::round(value * places) / places; }

constexpr std::pair<const char*, int> pins[] = {{"step", 2}, {"render", 3}, {"servo", 7}};

ordered_json durations(const std::vector<haptic::PinEdge>& edges, int pin) {
    ordered_json list = ordered_json::array();
    long long last = 0;
    for (const haptic::PinEdge& edge : edges) {
        if (edge.pin != pin) continue;
        const long long at = std::llround(haptic::seconds_of(edge.at) * 1e6);
        list.push_back(at - last);
        last = at;
    }
    return list;
}

}  // namespace

Replay::Replay(Session& session) { session.loop().record_edges(edges_); }

void Replay::watch(Session& session) {
    haptic::DeviceLoop& loop = session.loop();
    haptic::Plant& plant = loop.plant();
    const Status s = session.status();
    samples_.push_back({s.lever,
                        s.servo,
                        plant.servo_target(),
                        s.hand_force,
                        {plant.sensor_force(0), plant.sensor_force(1)},
                        {s.reading[0], s.reading[1]},
                        s.arm.value_or(0),
                        s.held});
    std::string cells;
    for (const std::string& line : s.screen) cells += line;
    if (screens_.empty() || screens_.back().cells != cells)
        screens_.push_back({loop.time(), cells});
}

std::string Replay::json(const Session& session) const {
    const haptic::Parameters parameters = haptic::published_parameters();
    ordered_json page = {{"scenario", session.scenario().name},
                         {"what", session.scenario().what},
                         {"arithmetic", session.firmware().arithmetic},
                         {"elf_sha256", simulator::Elf(session.firmware().elf).sha256()},
                         {"sample", sample},
                         {"plant",
                          {{"lever", parameters.lever.length},
                           {"sensor_radius", parameters.lever.sensor_radius},
                           {"foam", parameters.foam.thickness},
                           {"preload", parameters.foam.preload}}}};
    ordered_json& signals = page["signals"];
    const auto signal = [&](const char* name, double places, auto value) {
        ordered_json& list = signals[name] = ordered_json::array();
        for (const Sample& s : samples_) list.push_back(rounded(value(s), places));
    };
    signal("lever", 1e2, [](const Sample& s) { return s.lever / degrees(1); });
    signal("servo", 1e2, [](const Sample& s) { return s.servo / degrees(1); });
    signal("told", 1e2, [](const Sample& s) { return s.told / degrees(1); });
    signal("hand", 1e2, [](const Sample& s) { return s.hand; });
    signal("force_a", 1e2, [](const Sample& s) { return s.force[0]; });
    signal("force_b", 1e2, [](const Sample& s) { return s.force[1]; });
    signal("reading_a", 1, [](const Sample& s) { return s.reading[0]; });
    signal("reading_b", 1, [](const Sample& s) { return s.reading[1]; });
    signal("arm", 1e4, [](const Sample& s) { return s.arm; });
    ordered_json& held = signals["held"] = ordered_json::array();
    for (const Sample& s : samples_) held.push_back(s.held ? 1 : 0);
    for (const auto& [name, pin] : pins) page["pins"][name] = durations(edges_, pin);
    ordered_json& screens = page["screens"] = ordered_json::array();
    for (const Screen& screen : screens_)
        screens.push_back({{"at", rounded(screen.at, 1e3)}, {"cells", screen.cells}});
    return page.dump() + "\n";
}

}  // namespace live
