// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/scenes/measure_scenes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>

#include "bench/experiments/scenes/chip_run.hpp"
#include "bench/experiments/scenes/judge.hpp"
#include "bench/lab/parallel.hpp"
#include "bench/lab/program/names.hpp"
#include "bench/lab/records/progress.hpp"
#include "reference/trajectories/trajectory.hpp"

namespace scene_bench {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();
// The reference runs, on the host only.
constexpr std::string_view wide = "fifty_digits", recording = "double";

// Time steps, as exponents: on the chip; and on the host, whose results are bit for bit the chip's.
const std::vector<int> chip_exponents = {6, 8, 10};
const std::vector<int> host_exponents = {5, 6, 7, 8, 9, 10, 11, 12};
// For each scene, the quick run has programs in all scalars with one method, and with all methods
// in one scalar: CMake's scene_quick_programs.
bool has_quick_program(std::string_view scalar, std::string_view method) {
    return method == "semi_implicit_euler" || scalar == "q16_16";
}

struct Subject {
    const Scene* scene;
    std::string scalar, method;
    int exponent;
    bool on_chip;
};

// A method at a time step: what all scalars have in common.
struct Method {
    const Scene* scene;
    std::string method;
    int exponent;
    auto operator<=>(const Method&) const = default;
};

struct ReferenceRuns {
    Trajectory wide;
    double needed_range = 0;
};

bool wanted(const std::vector<std::string>& names, std::string_view name) {
    return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

bool contains(const std::vector<int>& exponents, int exponent) {
    return std::find(exponents.begin(), exponents.end(), exponent) != exponents.end();
}

// Arithmetics at the end of the names of fixed-point scalars: q16_16_published. `compensated` is
// the default one with compensated integration.
constexpr std::array<std::string_view, 3> named_arithmetics = {"published", "saturating",
                                                               "compensated"};

std::string arithmetic_of(std::string_view scalar) {
    if (scalar == "float") return "avr-libc";
    if (scalar == recording) return "host";
    if (scalar == wide) return "50 digits";
    for (const std::string_view arithmetic : named_arithmetics)
        if (scalar.ends_with(arithmetic)) return std::string(arithmetic);
    return "nearest";
}

std::string format_of(std::string_view scalar) {
    for (const std::string_view arithmetic : named_arithmetics)
        if (scalar.ends_with(arithmetic)) scalar.remove_suffix(1 + arithmetic.size());
    return std::string(scalar);
}

void add_once(std::vector<std::string>& names, const std::string& name) {
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
}

void check(const SceneOptions& options) {
    std::vector<std::string> scenes, scalars = {"float"}, methods;
    for (const Scene& scene : all_scenes()) {
        add_once(scenes, scene.name);
        for (const HostSubject& subject : scene.subjects) {
            add_once(scalars, subject.scalar);
            add_once(methods, subject.method);
        }
    }
    fixbench::check_names("--scene", options.scenes, scenes);
    fixbench::check_names("--scalar", options.scalars, scalars);
    fixbench::check_names("--method", options.methods, methods);
}

std::vector<Subject> subjects_of(const SceneOptions& options) {
    std::vector<Subject> subjects;
    for (const Scene& scene : all_scenes()) {
        if (!wanted(options.scenes, scene.name)) continue;
        for (const HostSubject& subject : scene.subjects) {
            if (!wanted(options.methods, subject.method)) continue;
            const bool is_reference = subject.scalar == wide || subject.scalar == recording;
            const auto has_program = [&](std::string_view scalar) {
                return !options.quick || has_quick_program(scalar, subject.method);
            };
            const auto add = [&](const std::string& scalar, int exponent, bool on_chip) {
                const bool in_mode = !options.quick || (on_chip ? exponent == 8 : exponent < 9);
                if (wanted(options.scalars, scalar) && in_mode)
                    subjects.push_back({&scene, scalar, subject.method, exponent, on_chip});
            };
            // The chip's float differs from the host's, and runs only there.
            if (subject.scalar == recording && has_program("float"))
                for (const int exponent : chip_exponents) add("float", exponent, true);
            for (const int exponent : host_exponents)
                add(subject.scalar, exponent,
                    !is_reference && has_program(subject.scalar) &&
                        contains(chip_exponents, exponent));
        }
    }
    return subjects;
}

std::vector<Subject> selected(const SceneOptions& options) {
    check(options);
    std::vector<Subject> subjects = subjects_of(options);
    if (subjects.empty())
        throw std::invalid_argument("no run has this scene, scalar and method together");
    return subjects;
}

std::filesystem::path program_of(const Subject& subject, const std::filesystem::path& programs) {
    return program_path(programs, subject.scene->name, subject.scalar, subject.method,
                        std::to_string(subject.exponent));
}

// At the times of a run; empty if only conserved quantities are known.
Trajectory truth_of(const Scene& scene) {
    reference::Times times;
    for (unsigned i = 0; i <= scene.duration * observations_per_second; ++i)
        times.push_back(static_cast<double>(i) / observations_per_second);
    return reference::trajectory(scene.name, times).value_or(Trajectory());
}

bool equal(const Trajectory& a, const Trajectory& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const State& s, const State& t) {
        return std::equal(s.begin(), s.end(), t.begin(), t.end(),
                          [](const ParticleState& p, const ParticleState& q) {
                              return p.position == q.position && p.velocity == q.velocity;
                          });
    });
}

ChipRun run(const Subject& subject, const std::filesystem::path& programs) {
    const HostSubject* const host = subject.scene->find(subject.scalar, subject.method);
    ChipRun run;
    if (subject.on_chip) {
        run = run_on_chip(program_of(subject, programs), *subject.scene, subject.scalar,
                          subject.exponent, Hashes::no);
    }
    if (host == nullptr) return run;
    Run on_host = host->run(subject.exponent, Hashes::no);
    if (!subject.on_chip) {
        static_cast<Run&>(run) = std::move(on_host);
        run.steps = static_cast<std::uint64_t>(subject.scene->duration) << subject.exponent;
    } else if (on_host.failure.empty() && !equal(on_host.trajectory, run.trajectory)) {
        throw std::runtime_error(fmt::format("{} {} {} 2^-{} s: chip and host differ",
                                             subject.scene->name, subject.scalar, subject.method,
                                             subject.exponent));
    }
    return run;
}

SceneRow row(const Subject& subject, const ChipRun& run, const ReferenceRuns& reference_runs,
             const Trajectory& truth) {
    const Scene& scene = *subject.scene;
    const bool is_wide = subject.scalar == wide;
    const bool has_truth = !truth.empty();
    const Trajectory& held_to = has_truth ? truth : reference_runs.wide;
    const double error = has_truth ? largest_distance(run.trajectory, truth) : none;
    const double error_method = has_truth ? largest_distance(reference_runs.wide, truth) : none;
    const double error_arithmetic =
        is_wide ? none : largest_distance(run.trajectory, reference_runs.wide);
    const double range = subject.scalar == wide || subject.scalar == recording
                             ? std::numeric_limits<double>::infinity()
                             : layout_of(subject.scalar).range();
    const std::string said =
        verdict({scene, run, has_truth ? error : error_arithmetic, error_method, extent(held_to),
                 range, reference_runs.needed_range});
    const double steps_a_second = std::ldexp(1.0, subject.exponent);
    const auto on_chip = [&](double value) {
        return subject.on_chip ? std::optional(value) : std::nullopt;
    };
    return {scene.name,
            format_of(subject.scalar),
            arithmetic_of(subject.scalar),
            subject.method,
            1 / steps_a_second,
            run.steps,
            on_chip(run.cycles_mean),
            on_chip(run.cycles_max),
            on_chip(run.cycles_mean * steps_a_second),
            error,
            error_method,
            error_arithmetic,
            "m",
            energy_drift(scene.name, run.trajectory, truth),
            on_chip(run.flash_bytes),
            on_chip(run.ram_bytes),
            on_chip(run.stack_bytes),
            said};
}

// Calls the task for each element, the most expensive first, with a progress bar.
template <class T, class Cost, class Task>
void for_all(const char* name, unsigned threads, const std::vector<T>& elements, Cost cost,
             Task task) {
    std::vector<std::size_t> order(elements.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return cost(elements[a]) > cost(elements[b]);
    });
    records::Progress progress(name, elements.size());
    operations::in_parallel(threads, elements.size(), [&](std::size_t i) {
        task(order[i]);
        progress.advance();
    });
}

}  // namespace

std::vector<std::string> programs_of(const SceneOptions& options) {
    std::vector<std::string> programs = {(options.programs / "empty.elf").string()};
    for (const Subject& subject : selected(options))
        if (subject.on_chip) programs.push_back(program_of(subject, options.programs).string());
    return programs;
}

void measure_scenes(const SceneOptions& options) {
    const std::vector<Subject> subjects = selected(options);

    std::map<const Scene*, Trajectory> truths;
    std::map<Method, ReferenceRuns> reference_runs;
    for (const Subject& subject : subjects) {
        if (!truths.contains(subject.scene)) truths[subject.scene] = truth_of(*subject.scene);
        reference_runs[{subject.scene, subject.method, subject.exponent}];
    }
    std::vector<std::pair<const Method, ReferenceRuns>*> methods;
    for (auto& entry : reference_runs) methods.push_back(&entry);
    for_all(
        "scenes in 50 digits", options.threads, methods,
        [](const auto* entry) { return entry->first.scene->particles << entry->first.exponent; },
        [&](std::size_t i) {
            const auto& [method, of] = *methods[i];
            methods[i]->second.wide = method.scene->find(wide, method.method)
                                          ->run(method.exponent, Hashes::no)
                                          .trajectory;
            methods[i]->second.needed_range = method.scene->find(recording, method.method)
                                                  ->run(method.exponent, Hashes::no)
                                                  .largest_number;
        });

    std::vector<SceneRow> rows(subjects.size());
    for_all(
        "scenes", options.threads, subjects,
        [](const Subject& subject) {
            return subject.on_chip ? subject.scene->particles << subject.exponent : 0;
        },
        [&](std::size_t i) {
            const Subject& subject = subjects[i];
            rows[i] = row(subject, run(subject, options.programs),
                          reference_runs.at({subject.scene, subject.method, subject.exponent}),
                          truths.at(subject.scene));
        });
    records::table_of(rows).save(options.output / "scenes.csv");
}

}  // namespace scene_bench
