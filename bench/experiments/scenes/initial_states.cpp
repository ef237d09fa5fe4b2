// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/scenes/initial_states.hpp"

#include <algorithm>
#include <cmath>
#include <scenes/all.hpp>

#include "bench/lab/parallel.hpp"
#include "bench/lab/program/names.hpp"
#include "bench/lab/records/progress.hpp"
#include "bench/lab/records/record.hpp"

namespace scene_bench {

template <class SceneType>
SceneStates states_of();

const std::vector<SceneStates>& scene_states() {
    static const std::vector<SceneStates> all = [] {
        std::vector<SceneStates> made;
        scenes::for_each_scene([&](auto scene) { made.push_back(states_of<decltype(scene)>()); });
        return made;
    }();
    return all;
}

std::optional<Spread> spread(std::vector<double> values) {
    if (values.empty()) return std::nullopt;
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    const double median =
        values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
    return Spread{values.front(), median, values.back()};
}

namespace {

using records::column;

// The time steps that the chip runs, too, as exponents.
constexpr int exponents[] = {6, 8, 10};

struct Row {
    std::string scene, scalar, arithmetic, integrator;
    double dt = 0;
    unsigned states = initial_states, held = 0;
    std::optional<double> smallest = {}, median = {}, largest = {};
    std::string unit = "m";

    static constexpr auto columns = std::tuple(
        column("scene", &Row::scene), column("scalar", &Row::scalar),
        column("arithmetic", &Row::arithmetic), column("integrator", &Row::integrator),
        column("dt", &Row::dt), column("states", &Row::states), column("held", &Row::held),
        column("error_min", &Row::smallest), column("error_median", &Row::median),
        column("error_max", &Row::largest), column("unit", &Row::unit));
};

Row row_of(const std::string& scene, const StateSubject& subject, int exponent) {
    std::vector<double> errors;
    for (unsigned seed = 1; seed <= initial_states; ++seed)
        if (const auto error = subject.error(seed, exponent)) errors.push_back(*error);
    Row row{scene, subject.scalar, subject.arithmetic, subject.method, std::ldexp(1.0, -exponent)};
    row.held = static_cast<unsigned>(errors.size());
    if (const auto of = spread(errors)) {
        row.smallest = of->smallest;
        row.median = of->median;
        row.largest = of->largest;
    }
    return row;
}

}  // namespace

void measure_initial_states(const StateOptions& options) {
    std::vector<std::string> names;
    for (const SceneStates& of : scene_states()) names.push_back(of.scene);
    fixbench::check_names("--scene", options.scenes, names);
    struct Work {
        const SceneStates* of;
        const StateSubject* subject;
        int exponent;
    };
    std::vector<Work> work;
    for (const SceneStates& of : scene_states()) {
        const auto& wanted = options.scenes;
        if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), of.scene) == wanted.end())
            continue;
        for (const StateSubject& subject : of.subjects)
            for (const int exponent : exponents) work.push_back({&of, &subject, exponent});
    }
    std::vector<Row> rows(work.size());
    records::Progress progress("initial states", work.size());
    operations::in_parallel(options.threads, work.size(), [&](std::size_t i) {
        rows[i] = row_of(work[i].of->scene, *work[i].subject, work[i].exponent);
        progress.advance();
    });
    records::table_of(rows).save(options.output / "initial_states.csv");
}

}  // namespace scene_bench
