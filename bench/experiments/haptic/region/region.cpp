// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/haptic/region/region.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/experiments/haptic/device_loop.hpp"
#include "bench/experiments/haptic/region/devices.hpp"
#include "bench/experiments/haptic/region/identification.hpp"
#include "bench/experiments/haptic/region/linear_loop.hpp"
#include "bench/lab/parallel.hpp"
#include "bench/lab/records/csv.hpp"
#include "bench/lab/records/progress.hpp"

namespace haptic::region {
namespace {

using records::cell;

// What is looked at: everything, or enough of it to see that it works.
struct Extent {
    std::vector<double> arms, hands;  // m, N/m
    std::vector<int> rates;
    std::size_t plants, plants_of_changes;
    double bisected;  // ratio at which a bisection ends

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

// A device as it is on the chip.
struct Subject {
    Device device;
    double step_takes;  // s
    // Arithmetic, damping, clock, loop rate.
    std::vector<std::string> cells() const {
        return {device.arithmetic, device.damped ? "yes" : "no",
                device.rate == 0 ? "report" : "fixed", cell(1 / device.law.step)};
    }
    Swing hold(const Parameters& plant, double arm, Start start = Start::taken_up) const {
        return device.hold(plant, arm, start, step_takes);
    }
    LinearLoop::Verdict theory(const Parameters& plant, double arm) const {
        return LinearLoop(plant, device.law, {arm, step_takes}).verdict();
    }
};

std::filesystem::path program_of(const Device& device) {
    return fmt::format(HELD_LEVER_FOLDER "/held_{}_{}_{}.elf", device.arithmetic, device.rate,
                       device.damped ? "damped" : "undamped");
}

// Of a step on the chip while the lever is held, by arithmetic.
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
        // The report's clock: a step is as long as the last one took, and 5 ms.
        if (device.rate == 0) {
            subject.device.law.step = subject.step_takes + 5e-3;
        } else {
            subject.step_takes = std::min(subject.step_takes, device.law.step);
        }
        subjects.push_back(subject);
    }
    return subjects;
}

// How a family of plants fares, one after the other.
struct Tally {
    int still = 0;
    Swing worst;
    void add(const Swing& swing) {
        still += swing.still();
        if (swing.size > worst.size) worst = swing;
    }
    std::vector<std::string> cells() const {
        return {cell(still), cell(worst.size / degrees(1)),
                worst.still() ? "" : cell(worst.frequency)};
    }
};
const std::vector<std::string> tallied{
    "still",        "worst_swing_deg",        "worst_frequency_hz",
    "still_thrown", "worst_thrown_swing_deg", "worst_thrown_frequency_hz"};

// Cells of a row, one after the other.
std::vector<std::string> operator+(std::vector<std::string> row,
                                   const std::vector<std::string>& more) {
    row.insert(row.end(), more.begin(), more.end());
    return row;
}

// `tallied` of the plants, taken up and thrown.
std::vector<std::string> tally(const Subject& subject, const std::vector<Parameters>& plants,
                               double arm) {
    Tally taken_up, thrown;
    for (const Parameters& plant : plants) {
        taken_up.add(subject.hold(plant, arm));
        thrown.add(subject.hold(plant, arm, Start::thrown));
    }
    return taken_up.cells() + thrown.cells();
}

// The family with another hand; 0 is each plant's own.
std::vector<Parameters> with_hand(std::vector<Parameters> plants, double stiffness) {
    for (Parameters& plant : plants)
        if (stiffness != 0) plant.hand.stiffness = stiffness;
    return plants;
}

// Rows of a table that are found in parallel and stand in the order of the work.
template <class Task>
records::Table table_of(const std::string& name, std::vector<std::string> columns, unsigned threads,
                        std::size_t rows, Task&& task) {
    std::vector<std::vector<std::string>> found(rows);
    records::Progress progress(name, rows);
    operations::in_parallel(threads, rows, [&](std::size_t i) {
        found[i] = task(i);
        progress.advance();
    });
    records::Table table(std::move(columns));
    for (auto& row : found) table.add(std::move(row));
    return table;
}

void write_map(const std::vector<Subject>& subjects, const std::vector<Parameters>& all,
               const Extent& extent, const Options& options) {
    const std::size_t hands = extent.hands.size(), arms = extent.arms.size();
    const std::vector<std::string> of_theory{"linear_stable", "linear_worst_radius",
                                             "linear_frequency_hz"};
    table_of("stable region",
             std::vector<std::string>{"arithmetic", "damping", "clock", "loop_rate_hz", "arm_m",
                                      "hand_n_per_m", "plants"} +
                 tallied + of_theory,
             options.threads, subjects.size() * arms * hands,
             [&](std::size_t i) {
                 const Subject& subject = subjects[i / (arms * hands)];
                 const double arm = extent.arms[i / hands % arms], hand = extent.hands[i % hands];
                 const std::vector<Parameters> plants = with_hand(all, hand);
                 int stable = 0;
                 LinearLoop::Verdict worst{0, 0};
                 for (const Parameters& plant : plants) {
                     const LinearLoop::Verdict verdict = subject.theory(plant, arm);
                     stable += verdict.stable();
                     if (verdict.radius > worst.radius) worst = verdict;
                 }
                 return subject.cells() +
                        std::vector{cell(arm), cell(hand),
                                    cell(static_cast<double>(plants.size()))} +
                        tally(subject, plants, arm) +
                        std::vector{cell(stable), cell(worst.radius), cell(worst.frequency)};
             })
        .save(options.output / "stable_region.csv");
}

// The end of the range of `still` values that begins at `from`, towards `to`, within a ratio; NaN
// where not even `from` is still.
template <class Still>
double limit(double from, double to, double ratio, Still&& still) {
    if (!still(from)) return std::nan("");
    if (still(to)) return to;
    while (std::max(from / to, to / from) > ratio) {
        const double middle = std::sqrt(from * to);
        (still(middle) ? from : to) = middle;
    }
    return from;
}

void write_limits(const std::vector<Subject>& subjects, const std::vector<Parameters>& plants,
                  const Extent& extent, const Options& options) {
    constexpr double softest = 10, hardest = 20000;          // N/m
    constexpr double theory_least = 0.02, theory_most = 20;  // m
    table_of(
        "stable limits",
        {"arithmetic", "damping", "clock", "loop_rate_hz", "plant", "own_hand_n_per_m",
         "still_at_shortest", "shortest_arm_m", "softest_hand_n_per_m", "hardest_hand_n_per_m",
         "linear_shortest_arm_m"},
        options.threads, subjects.size() * plants.size(),
        [&](std::size_t i) {
            const Subject& subject = subjects[i / plants.size()];
            const Parameters& plant = plants[i % plants.size()];
            const double own = plant.hand.stiffness;
            const auto still_at_hand = [&](double hand) {
                Parameters held = plant;
                held.hand.stiffness = hand;
                return subject.hold(held, shortest_arm).still();
            };
            return subject.cells() +
                   std::vector<std::string>{
                       cell(static_cast<double>(i % plants.size() + 1)),
                       cell(own),
                       still_at_hand(own) ? "yes" : "no",
                       cell(limit(longest_arm, shortest_arm, 1.02,
                                  [&](double arm) { return subject.hold(plant, arm).still(); })),
                       cell(limit(own, softest, extent.bisected, still_at_hand)),
                       cell(limit(own, hardest, extent.bisected, still_at_hand)),
                       cell(limit(theory_most, theory_least, 1.01, [&](double arm) {
                           return subject.theory(plant, arm).stable();
                       }))};
        })
        .save(options.output / "stable_limits.csv");
}

void write_changes(const std::vector<Subject>& subjects, const std::vector<Parameters>& plants,
                   const Options& options) {
    const std::vector<double> hands{0, 100, 1000};
    table_of("changes of method",
             std::vector<std::string>{"change", "arithmetic", "damping", "clock", "loop_rate_hz",
                                      "arm_m", "hand_n_per_m", "plants"} +
                 tallied,
             options.threads, subjects.size() * hands.size(),
             [&](std::size_t i) {
                 const Subject& subject = subjects[i / hands.size()];
                 const double hand = hands[i % hands.size()];
                 return std::vector{subject.device.change} + subject.cells() +
                        std::vector{cell(shortest_arm), hand == 0 ? "own" : cell(hand),
                                    cell(static_cast<double>(plants.size()))} +
                        tally(subject, with_hand(plants, hand), shortest_arm);
             })
        .save(options.output / "stable_changes.csv");
}

void check_on_chip(const std::vector<Subject>& all, const std::vector<Parameters>& plants,
                   const Options& options) {
    std::vector<Subject> subjects;
    for (const Subject& subject : all)
        if (std::filesystem::exists(program_of(subject.device))) subjects.push_back(subject);
    const records::Table table = table_of(
        "region on the chip",
        {"arithmetic", "damping", "clock", "loop_rate_hz", "arm_m", "plant", "chip_swing_deg",
         "chip_frequency_hz", "host_swing_deg", "chip", "host", "elf_sha256"},
        options.threads, subjects.size() * plants.size(), [&](std::size_t i) {
            const Subject& subject = subjects[i / plants.size()];
            const Parameters& plant = plants[i % plants.size()];
            const simulator::Elf elf(program_of(subject.device));
            DeviceLoop loop(elf, plant, Holding(shortest_arm).script);
            const Swing chip = watch_held(loop), host = subject.hold(plant, shortest_arm);
            const auto verdict = [](const Swing& swing) {
                return swing.still() ? "still" : "swings";
            };
            return subject.cells() +
                   std::vector<std::string>{cell(shortest_arm),
                                            cell(static_cast<double>(i % plants.size() + 1)),
                                            cell(chip.size / degrees(1)),
                                            chip.still() ? "" : cell(chip.frequency),
                                            cell(host.size / degrees(1)),
                                            verdict(chip),
                                            verdict(host),
                                            elf.sha256()};
        });
    const std::size_t chip = table.column("chip"), host = table.column("host");
    std::size_t agree = 0;
    for (const auto& row : table.rows()) {
        if (row[chip] == row[host]) {
            ++agree;
        } else {
            fmt::print(stderr, "differs: {}\n", fmt::join(row.begin(), row.end() - 1, ","));
        }
    }
    fmt::print(stderr, "chip and host agree on {} of {} points\n", agree, table.rows().size());
    table.save(options.output / "stable_on_chip.csv");
}

// The lever over time on a plant, by the chip.
void write_oscillation(const Parameters& plant, const Options& options) {
    constexpr double interval = 5e-3;
    std::vector<std::string> columns{"time_s"};
    std::vector<Device> list;
    for (const Device& device : devices())
        if ((device.arithmetic == "q16_16" && device.rate == 10) || device.rate == 0) {
            list.push_back(device);
            columns.push_back(
                fmt::format("{}_{}_deg", device.arithmetic, device.damped ? "damped" : "undamped"));
        }
    const auto rows = static_cast<std::size_t>(Holding::end / interval);
    std::vector<std::vector<double>> traces(list.size());
    records::Progress progress("oscillation", list.size());
    operations::in_parallel(options.threads, list.size(), [&](std::size_t i) {
        DeviceLoop loop(simulator::Elf(program_of(list[i])), plant, Holding(shortest_arm).script);
        for (std::size_t row = 0; row < rows; ++row) {
            loop.run_until(static_cast<double>(row) * interval);
            traces[i].push_back(loop.plant().lever_angle() / degrees(1));
        }
        progress.advance();
    });
    records::Table table(columns);
    for (std::size_t row = 0; row < rows; ++row) {
        std::vector<std::string> cells{cell(static_cast<double>(row) * interval)};
        for (const auto& trace : traces) cells.push_back(fmt::format("{:.3f}", trace[row]));
        table.add(std::move(cells));
    }
    table.save(options.output / "oscillation.csv");
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
    table_of(identification, published_step, options.threads)
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
