// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/haptic/region/region.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/experiments/haptic/device_loop.hpp"
#include "bench/experiments/haptic/region/devices.hpp"
#include "bench/experiments/haptic/region/identification.hpp"
#include "bench/experiments/haptic/region/linear_loop.hpp"
#include "bench/lab/parallel.hpp"
#include "bench/lab/records/progress.hpp"
#include "bench/lab/records/record.hpp"
#include "this_build.hpp"

namespace haptic::region {
namespace {

using records::column;

// The extent of the study: everything, or enough of it to see that it works.
struct Extent {
    std::vector<double> arms, hands;  // m, N/m
    std::vector<int> rates;
    std::size_t plants, plants_of_changes;
    double bisected;  // ratio at which a bisection stops

    explicit Extent(bool quick)
        : arms(quick ? std::vector{0.23, 0.48} : std::vector{0.23, 0.28, 0.33, 0.38, 0.43, 0.48}),
          hands(quick ? std::vector<double>{100, 1000}
                      : std::vector<double>{30, 60, 120, 250, 500, 1000, 2000}),
          rates(quick ? std::vector{0, 10} : std::vector{0, 7, 8, 9, 10, 11}),
          plants(quick ? 2 : 12),
          plants_of_changes(quick ? 4 : 128),
          bisected(quick ? 1.5 : 1.05) {}

    bool holds(const Device& device) const {
        return std::find(rates.begin(), rates.end(), device.rate) != rates.end();
    }
};

// The first columns of the rows of several files.
struct DeviceRow {
    std::string arithmetic;
    bool damping;
    std::string clock;
    double loop_rate_hz;

    static constexpr auto columns = std::tuple(
        column("arithmetic", &DeviceRow::arithmetic), column("damping", &DeviceRow::damping),
        column("clock", &DeviceRow::clock), column("loop_rate_hz", &DeviceRow::loop_rate_hz));
};

// A device as it runs on the chip.
struct Subject {
    Device device;
    double step_takes;  // s
    DeviceRow row() const {
        return {device.arithmetic, device.damped, device.rate == 0 ? "published" : "fixed",
                1 / device.law.step};
    }
    Swing hold(const Parameters& plant, double arm, Start start = Start::grasped) const {
        return device.hold(plant, arm, start, step_takes);
    }
    LinearLoop::Verdict theory(const Parameters& plant, double arm) const {
        return LinearLoop(plant, device.law, {arm, step_takes}).verdict();
    }
};

std::filesystem::path program_of(const Device& device) {
    return build_folder() / "bench/experiments/haptic/region" /
           fmt::format("held_{}_{}_{}.elf", device.arithmetic, device.rate,
                       device.damped ? "damped" : "undamped");
}

// The time of a step on the chip while the lever is held, by arithmetic.
std::map<std::string, double> step_times() {
    std::map<std::string, double> times;
    for (const Device& device : devices()) {
        if (times.contains(device.arithmetic) || !device.damped ||
            !std::filesystem::exists(program_of(device)))
            continue;
        DeviceLoop loop(simulator::Elf(program_of(device)), published_parameters(),
                        Holding(shortest_arm).script);
        loop.run_until(1);
        const auto& lengths = loop.timing().step_lengths;
        times[device.arithmetic] =
            seconds_of(std::accumulate(lengths.begin(), lengths.end(), Cycle{0})) /
            static_cast<double>(lengths.size());
    }
    return times;
}

std::vector<Subject> subjects_of(const std::vector<Device>& list,
                                 const std::map<std::string, double>& step_times) {
    std::vector<Subject> subjects;
    for (const Device& device : list) {
        Subject subject{device, step_times.at(device.arithmetic)};
        // The clock of the 2016 design: a step is as long as the last one took, plus 5 ms.
        if (device.rate == 0) {
            subject.device.law.step = subject.step_takes + 5e-3;
        } else {
            subject.step_takes = std::min(subject.step_takes, device.law.step);
        }
        subjects.push_back(subject);
    }
    return subjects;
}

// The family with another hand; 0 leaves each plant its own.
std::vector<Parameters> with_hand(std::vector<Parameters> plants, double stiffness) {
    for (Parameters& plant : plants)
        if (stiffness != 0) plant.hand.stiffness = stiffness;
    return plants;
}

std::optional<double> frequency_of(const Swing& swing) {
    return swing.at_rest() ? std::nullopt : std::optional(swing.frequency);
}

// How a family of plants behaves, grasped and released against. A plant at rest has no frequency.
struct FamilyRow : DeviceRow {
    double arm_m;
    std::string hand_n_per_m;  // or "own"
    std::size_t plants;
    int at_rest = 0;
    double swing_deg = 0;
    std::optional<double> frequency_hz;
    int released_at_rest = 0;
    double released_swing_deg = 0;
    std::optional<double> released_frequency_hz;

    static constexpr auto columns = std::tuple_cat(
        DeviceRow::columns,
        std::tuple(column("arm_m", &FamilyRow::arm_m),
                   column("hand_n_per_m", &FamilyRow::hand_n_per_m),
                   column("plants", &FamilyRow::plants), column("at_rest", &FamilyRow::at_rest),
                   column("worst_swing_deg", &FamilyRow::swing_deg),
                   column("worst_frequency_hz", &FamilyRow::frequency_hz),
                   column("released_at_rest", &FamilyRow::released_at_rest),
                   column("worst_released_swing_deg", &FamilyRow::released_swing_deg),
                   column("worst_released_frequency_hz", &FamilyRow::released_frequency_hz)));

    FamilyRow(const Subject& subject, const std::vector<Parameters>& family, double arm,
              double hand)
        : DeviceRow(subject.row()),
          arm_m(arm),
          hand_n_per_m(hand == 0 ? "own" : records::cell(hand)),
          plants(family.size()) {
        const auto add = [](const Swing& swing, int& at_rest, double& worst_deg,
                            std::optional<double>& frequency) {
            at_rest += swing.at_rest();
            if (swing.size / degrees(1) <= worst_deg) return;
            worst_deg = swing.size / degrees(1);
            frequency = frequency_of(swing);
        };
        for (const Parameters& plant : with_hand(family, hand)) {
            add(subject.hold(plant, arm), at_rest, swing_deg, frequency_hz);
            add(subject.hold(plant, arm, Start::released_against), released_at_rest,
                released_swing_deg, released_frequency_hz);
        }
    }
    FamilyRow() = default;
};

// Rows computed in parallel, in the order of the work.
template <class Task>
auto found_in_parallel(const std::string& name, unsigned threads, std::size_t rows, Task&& task) {
    std::vector<decltype(task(rows))> found(rows);
    records::Progress progress(name, rows);
    operations::in_parallel(threads, rows, [&](std::size_t i) {
        found[i] = task(i);
        progress.advance();
    });
    return found;
}

// A row of stable_region.csv.
struct RegionRow : FamilyRow {
    int linear_stable = 0;
    double linear_worst_radius = 0, linear_frequency_hz = 0;

    static constexpr auto columns =
        std::tuple_cat(FamilyRow::columns,
                       std::tuple(column("linear_stable", &RegionRow::linear_stable),
                                  column("linear_worst_radius", &RegionRow::linear_worst_radius),
                                  column("linear_frequency_hz", &RegionRow::linear_frequency_hz)));
};

void write_map(const std::vector<Subject>& subjects, const std::vector<Parameters>& all,
               const Extent& extent, const Options& options) {
    const std::size_t hands = extent.hands.size(), arms = extent.arms.size();
    const auto rows = found_in_parallel(
        "stable region", options.threads, subjects.size() * arms * hands, [&](std::size_t i) {
            const Subject& subject = subjects[i / (arms * hands)];
            const double arm = extent.arms[i / hands % arms], hand = extent.hands[i % hands];
            RegionRow row{{subject, all, arm, hand}};
            for (const Parameters& plant : with_hand(all, hand)) {
                const LinearLoop::Verdict verdict = subject.theory(plant, arm);
                row.linear_stable += verdict.stable();
                if (verdict.radius <= row.linear_worst_radius) continue;
                row.linear_worst_radius = verdict.radius;
                row.linear_frequency_hz = verdict.frequency;
            }
            return row;
        });
    records::table_of(rows).save(options.output / "stable_region.csv");
}

// The end of the range of values `at_rest` that starts at `from`, towards `to`, within a ratio;
// none if not even `from` is.
template <class AtRest>
std::optional<double> limit(double from, double to, double ratio, AtRest&& at_rest) {
    if (!at_rest(from)) return std::nullopt;
    if (at_rest(to)) return to;
    while (std::max(from / to, to / from) > ratio) {
        const double middle = std::sqrt(from * to);
        (at_rest(middle) ? from : to) = middle;
    }
    return from;
}

// A row of stable_limits.csv. A plant that is never at rest has no limits.
struct LimitsRow : DeviceRow {
    std::size_t plant;
    double own_hand;
    bool at_rest_at_shortest;
    std::optional<double> shortest_arm, softest_hand, hardest_hand, linear_shortest_arm;

    static constexpr auto columns = std::tuple_cat(
        DeviceRow::columns,
        std::tuple(column("plant", &LimitsRow::plant),
                   column("own_hand_n_per_m", &LimitsRow::own_hand),
                   column("at_rest_at_shortest", &LimitsRow::at_rest_at_shortest),
                   column("shortest_arm_m", &LimitsRow::shortest_arm),
                   column("softest_hand_n_per_m", &LimitsRow::softest_hand),
                   column("hardest_hand_n_per_m", &LimitsRow::hardest_hand),
                   column("linear_shortest_arm_m", &LimitsRow::linear_shortest_arm)));
};

void write_limits(const std::vector<Subject>& subjects, const std::vector<Parameters>& plants,
                  const Extent& extent, const Options& options) {
    constexpr double softest = 10, hardest = 20000;          // N/m
    constexpr double theory_least = 0.02, theory_most = 20;  // m
    const auto rows = found_in_parallel(
        "stable limits", options.threads, subjects.size() * plants.size(), [&](std::size_t i) {
            const Subject& subject = subjects[i / plants.size()];
            const Parameters& plant = plants[i % plants.size()];
            const double own = plant.hand.stiffness;
            const auto at_rest_at_arm = [&](double arm) {
                return subject.hold(plant, arm).at_rest();
            };
            const auto at_rest_at_hand = [&](double hand) {
                Parameters held = plant;
                held.hand.stiffness = hand;
                return subject.hold(held, shortest_arm).at_rest();
            };
            const auto stable = [&](double arm) { return subject.theory(plant, arm).stable(); };
            return LimitsRow{subject.row(),
                             i % plants.size() + 1,
                             own,
                             at_rest_at_hand(own),
                             limit(longest_arm, shortest_arm, 1.02, at_rest_at_arm),
                             limit(own, softest, extent.bisected, at_rest_at_hand),
                             limit(own, hardest, extent.bisected, at_rest_at_hand),
                             limit(theory_most, theory_least, 1.01, stable)};
        });
    records::table_of(rows).save(options.output / "stable_limits.csv");
}

// A row of stable_changes.csv.
struct ChangesRow : FamilyRow {
    std::string change;

    static constexpr auto columns =
        std::tuple_cat(std::tuple(column("change", &ChangesRow::change)), FamilyRow::columns);
};

void write_changes(const std::vector<Subject>& subjects, const std::vector<Parameters>& plants,
                   const Options& options) {
    const std::vector<double> hands{0, 100, 1000};
    const auto rows = found_in_parallel(
        "changes of method", options.threads, subjects.size() * hands.size(), [&](std::size_t i) {
            const Subject& subject = subjects[i / hands.size()];
            return ChangesRow{{subject, plants, shortest_arm, hands[i % hands.size()]},
                              subject.device.change};
        });
    records::table_of(rows).save(options.output / "stable_changes.csv");
}

// A row of stable_on_chip.csv.
struct ChipRow : DeviceRow {
    double arm_m;
    std::size_t plant;
    double chip_swing_deg;
    std::optional<double> chip_frequency_hz;
    double host_swing_deg;
    std::string chip, host, elf_sha256;

    static constexpr auto columns = std::tuple_cat(
        DeviceRow::columns,
        std::tuple(column("arm_m", &ChipRow::arm_m), column("plant", &ChipRow::plant),
                   column("chip_swing_deg", &ChipRow::chip_swing_deg),
                   column("chip_frequency_hz", &ChipRow::chip_frequency_hz),
                   column("host_swing_deg", &ChipRow::host_swing_deg),
                   column("chip", &ChipRow::chip), column("host", &ChipRow::host),
                   column("elf_sha256", &ChipRow::elf_sha256)));
};

void check_on_chip(const std::vector<Subject>& all, const std::vector<Parameters>& plants,
                   const Options& options) {
    std::vector<Subject> subjects;
    for (const Subject& subject : all)
        if (std::filesystem::exists(program_of(subject.device))) subjects.push_back(subject);
    const auto rows = found_in_parallel(
        "region on the chip", options.threads, subjects.size() * plants.size(), [&](std::size_t i) {
            const Subject& subject = subjects[i / plants.size()];
            const Parameters& plant = plants[i % plants.size()];
            const simulator::Elf elf(program_of(subject.device));
            DeviceLoop loop(elf, plant, Holding(shortest_arm).script);
            const Swing chip = watch_held(loop), host = subject.hold(plant, shortest_arm);
            const auto verdict = [](const Swing& swing) {
                return swing.at_rest() ? "at_rest" : "swings";
            };
            return ChipRow{subject.row(),          shortest_arm,       i % plants.size() + 1,
                           chip.size / degrees(1), frequency_of(chip), host.size / degrees(1),
                           verdict(chip),          verdict(host),      elf.sha256()};
        });
    std::size_t agree = 0;
    for (const ChipRow& row : rows) {
        if (row.chip == row.host)
            ++agree;
        else
            fmt::print(stderr, "differs: {} of {:.0f} Hz, plant {}: {} on the chip\n",
                       row.arithmetic, row.loop_rate_hz, row.plant, row.chip);
    }
    fmt::print(stderr, "chip and host agree on {} of {} points\n", agree, rows.size());
    records::table_of(rows).save(options.output / "stable_on_chip.csv");
}

// The devices whose motion is shown over time.
std::vector<Device> shown_over_time() {
    std::vector<Device> list;
    for (const Device& device : devices())
        if ((device.arithmetic == "q16_16" && device.rate == 10) || device.rate == 0)
            list.push_back(device);
    return list;
}

// A row of oscillation.csv.
struct OscillationRow {
    double time_s;
    std::vector<double> degrees;

    static std::vector<std::string> names() {
        std::vector<std::string> list;
        for (const Device& device : shown_over_time())
            list.push_back(
                fmt::format("{}_{}_deg", device.arithmetic, device.damped ? "damped" : "undamped"));
        return list;
    }
    static constexpr auto columns =
        std::tuple(column("time_s", &OscillationRow::time_s),
                   records::columns_of(&names, &OscillationRow::degrees, "{:.3f}"));
};

// The motion of the lever over time on a plant, by the chip.
void write_oscillation(const Parameters& plant, const Options& options) {
    constexpr double interval = 5e-3;
    const std::vector<Device> list = shown_over_time();
    std::vector<OscillationRow> rows(static_cast<std::size_t>(Holding::end / interval),
                                     {0, std::vector<double>(list.size())});
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i].time_s = static_cast<double>(i) * interval;
    records::Progress progress("oscillation", list.size());
    operations::in_parallel(options.threads, list.size(), [&](std::size_t i) {
        DeviceLoop loop(simulator::Elf(program_of(list[i])), plant, Holding(shortest_arm).script);
        for (OscillationRow& row : rows) {
            loop.run_until(row.time_s);
            row.degrees[i] = loop.plant().lever_angle() / degrees(1);
        }
        progress.advance();
    });
    records::table_of(rows).save(options.output / "oscillation.csv");
}

}  // namespace

void measure_region(const Options& options) {
    const Extent extent(options.quick);
    const std::map<std::string, double> times = step_times();
    std::vector<Subject> subjects;
    for (const Subject& subject : subjects_of(devices(), times))
        if (extent.holds(subject.device)) subjects.push_back(subject);
    const double published_step = times.at("published");
    const Identification identification =
        identify(extent.plants_of_changes, published_step, options.threads);
    records::table_of(rows_of(identification, published_step, options.threads))
        .save(options.output / "identification.csv");
    const std::vector<Parameters> plants = identification.plants(extent.plants);
    write_map(subjects, plants, extent, options);
    write_limits(subjects, plants, extent, options);
    write_changes(subjects_of(changes(), times), identification.plants(extent.plants_of_changes),
                  options);
    check_on_chip(subjects, plants, options);
    write_oscillation(plants.front(), options);
}

}  // namespace haptic::region
