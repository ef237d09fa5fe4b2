// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/ablations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bench/experiments/stability/chip_world.hpp"
#include "bench/experiments/stability/search.hpp"
#include "bench/lab/parallel.hpp"
#include "bench/lab/records/progress.hpp"
#include "this_build.hpp"

namespace stability {
namespace {

// A method of Q16.16 and its arithmetic.
struct Method {
    const char *arithmetic, *integrator;
};
constexpr Method ours{"nearest", "semi_implicit_euler"};
constexpr Method verlet{"nearest", "velocity_verlet"};
constexpr Method direct_rods{"nearest", "direct_rods"};
constexpr Method implicit_springs{"nearest", "implicit_springs"};
constexpr Method direct_springs{"nearest", "direct_springs"};
constexpr Method implicit_midpoint{"nearest", "implicit_midpoint"};
constexpr Method gauss_seidel_springs{"nearest", "gauss_seidel_springs"};
constexpr Method compensated_integration{"nearest", "semi_implicit_compensated"};
constexpr Method positions_first{"nearest", "positions_first"};
constexpr Method worst_contact_first{"nearest", "worst_contact_first"};
constexpr Method opposed_contacts{"nearest", "rods_as_opposed_contacts"};
constexpr Method tangent_rods{"nearest", "rods_along_tangents"};
constexpr Method late_bounces{"nearest", "bounces_when_found"};
constexpr Method impulses{"nearest", "velocities_by_impulses"};
constexpr Method one_iteration{"nearest", "one_iteration"};
constexpr Method warm_started{"nearest", "warm_started"};
constexpr Method continuous_contacts{"nearest", "continuous_contacts"};
constexpr Method saturating{"saturating", "semi_implicit_euler"};

// The engine before and after differs only in the ablation. Cycles are those of the case at the
// parameter `timed_at`, where both hold, or at its easy end.
constexpr struct {
    const char *ablation, *found_by;
    Method before, after;
    double timed_at;
} ablations[] = {
    {"velocities before positions", "spring_frame_step", positions_first, ours, 0.01},
    {"velocities before positions", "spring_stiffness", positions_first, ours, 10},
    {"springs solved implicitly", "spring_coarse_step", ours, implicit_springs, 0.03},
    {"springs solved implicitly", "spring_critically_damped", ours, implicit_springs, 0.01},
    {"springs solved implicitly", "spring_light_and_stiff", ours, implicit_springs, 1},
    {"springs solved together", "spring_chain_of_4_heavy_end", implicit_springs, direct_springs, 1},
    {"springs solved together", "spring_chain_of_16_heavy_end", implicit_springs, direct_springs,
     1},
    {"springs solved in ten iterations", "spring_chain_of_4_heavy_end", implicit_springs,
     gauss_seidel_springs, 1},
    {"springs solved in ten iterations", "spring_chain_of_16_heavy_end", implicit_springs,
     gauss_seidel_springs, 1},
    {"springs at the middle of the step", "spring_critically_damped", verlet, implicit_midpoint,
     0.01},
    {"a rod as one two-sided constraint", "rod_speed", opposed_contacts, tangent_rods, 0.1},
    {"a rod as one two-sided constraint", "rod_chain_of_8_heavy_end", opposed_contacts,
     tangent_rods, 1},
    {"rods along the chord of the arc", "rod_speed", tangent_rods, ours, 0.1},
    {"iterations over all contacts", "stack_of_5", worst_contact_first, ours, 1},
    {"iterations over all contacts", "stack_of_10", worst_contact_first, ours, 1},
    {"iterations begun where the last step ended", "stack_of_20", ours, warm_started, 1},
    {"iterations begun where the last step ended", "rod_chain_of_4_heavy_end", ours, warm_started,
     1},
    {"iterations begun where the last step ended", "rod_chain_of_8_heavy_end", ours, warm_started,
     1},
    {"iterations begun where the last step ended", "rod_chain_of_16_heavy_end", ours, warm_started,
     1},
    {"ten iterations in place of one", "rod_chain_of_4_heavy_end_fine_steps", one_iteration, ours,
     1},
    {"ten iterations in place of one", "rod_chain_of_8_heavy_end_fine_steps", one_iteration, ours,
     1},
    {"ten iterations in place of one", "rod_chain_of_16_heavy_end_fine_steps", one_iteration, ours,
     1},
    {"rods solved together", "rod_chain_of_4_heavy_end", verlet, direct_rods, 1},
    {"rods solved together", "rod_chain_of_8_heavy_end", verlet, direct_rods, 1},
    {"rods solved together", "rod_chain_of_16_heavy_end", verlet, direct_rods, 1},
    {"contacts on the way of fast particles", "thin_wall", ours, continuous_contacts, 0.5},
    {"contacts on the way of fast particles", "thin_target", ours, continuous_contacts, 0.5},
    {"bounces back-dated", "bounces_under_gravity", late_bounces, ours, 1000},
    {"shares in place of impulses", "resting_light_mass", impulses, ours, 1},
    {"residuals of products with the step", "slow", ours, compensated_integration, 10},
    {"residuals of products with the step", "small_binary_step", ours, compensated_integration,
     0x1p-8},
    {"residuals of products with the step", "weak_gravity", ours, compensated_integration, 10},
    {"sums and products that saturate", "spring_extension", ours, saturating, 0.1},
    {"sums and products that saturate", "drag_quadratic", ours, saturating, 1},
};

const Subject& subject_of(Method method) {
    return subject("q16_16", method.arithmetic, method.integrator);
}
// The part that distinguishes it from ours.
std::string name_of(Method method) {
    return method.arithmetic == std::string("nearest") ? method.integrator : method.arithmetic;
}

struct Cycles {
    double mean;
    std::uint32_t most;
};
// Of a step of the program that contains only the case.
Cycles cycles_of(const Case& one, Method method, double parameter) {
    constexpr unsigned max_steps = 1000;
    const Description description = one.at(parameter).description;
    const std::filesystem::path program =
        build_folder() / "bench/experiments/stability" /
        fmt::format("ablation_{}_{}.elf", one.name, name_of(method));
    ChipWorld world(program, description);
    std::uint64_t sum = 0;
    std::uint32_t most = 0;
    const unsigned steps = std::min(description.steps, max_steps);
    for (unsigned step = 0; step < steps; ++step) {
        const std::uint32_t cycles = world.step();
        sum += cycles;
        most = std::max(most, cycles);
    }
    if (world.error() != engine::Error::none)
        throw std::runtime_error(fmt::format("{}: {}", program.string(), describe(world.error())));
    return {double(sum) / steps, most};
}

// A parameter that the method before does not withstand: half beyond its limit.
double beyond(const Case& one, double limit) {
    if (std::isnan(limit)) return one.from;
    if (one.endurance) return std::min(one.to, 2 * limit);
    return limit * (one.to > one.from ? 1.5 : 1 / 1.5);
}

// The measure of the case, in tolerances. None if the engine reports an error, or the format does
// not hold the case.
std::optional<double> error_of(const Case& one, Method method, double parameter) {
    const Trial trial = attempt(subject_of(method), one.at(parameter), 1e9);
    if (!trial.outcome.error.empty() || trial.outcome.steps == 0) return {};
    return trial.worst;
}

std::optional<double> limit_or_none(const Finding& finding) {
    if (std::isnan(finding.limit)) return {};
    return finding.limit;
}

AblationRow row(std::size_t i, const Effort& effort) {
    const auto& ablation = ablations[i];
    const Case& one = case_named(ablation.found_by);
    const Finding was = find_limit(one, subject_of(ablation.before), effort);
    const Finding is = find_limit(one, subject_of(ablation.after), effort);
    const double broken = beyond(one, was.limit);
    const Cycles before = cycles_of(one, ablation.before, ablation.timed_at);
    const Cycles after = cycles_of(one, ablation.after, ablation.timed_at);
    return {ablation.ablation,
            one.name,
            one.parameter,
            one.unit,
            name_of(ablation.before),
            name_of(ablation.after),
            limit_or_none(was),
            limit_or_none(is),
            error_of(one, ablation.before, broken),
            error_of(one, ablation.after, broken),
            before.mean,
            after.mean,
            before.most,
            after.most,
            cause_of(was),
            cause_of(is)};
}

}  // namespace

void measure_ablations(const std::filesystem::path& output, const Effort& effort,
                       unsigned threads) {
    std::vector<AblationRow> rows(std::size(ablations));
    records::Progress progress("ablations", rows.size());
    operations::in_parallel(threads, rows.size(), [&](std::size_t i) {
        rows[i] = row(i, effort);
        progress.advance();
    });
    records::table_of(rows).save(output / "ablations.csv");
}

}  // namespace stability
