// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/haptic/region/identification.hpp"

#include <algorithm>
#include <stdexcept>

#include "bench/experiments/haptic/region/devices.hpp"
#include "bench/lab/parallel.hpp"
#include "bench/lab/records/progress.hpp"
#include "reference/published.hpp"

namespace haptic::region {
namespace {

const Device& published(bool damped) {
    static const std::vector<Device> list = devices();
    return *std::ranges::find_if(list, [&](const Device& device) {
        return device.arithmetic == "published" && device.rate == 0 && device.damped == damped;
    });
}

Identification::Draw drawn(std::uint64_t seed, double step_takes) {
    static const double as_published = published_fall();
    Identification::Draw draw{seed, varied(published_parameters(), seed), {}, 0, false};
    draw.fall = published(false).fall(draw.plant, step_takes);
    if (!draw.fall || !reference::within_10_percent(*draw.fall / as_published)) return draw;
    const Swing swing = published(false).hold(draw.plant, shortest_arm, Start::grasped, step_takes);
    draw.swing = swing.size;
    draw.as_published = !swing.at_rest();
    return draw;
}

}  // namespace

std::vector<Parameters> Identification::plants(std::size_t count) const {
    std::vector<Parameters> list;
    for (const Draw& draw : draws)
        if (draw.as_published && list.size() < count) list.push_back(draw.plant);
    if (list.size() < count) throw std::out_of_range("fewer plants behave as published");
    return list;
}

Identification identify(std::size_t count, double step_takes, unsigned threads) {
    constexpr std::size_t batch = 64, most = 50;
    Identification found;
    records::Progress progress("plants as published", count);
    std::size_t accepted = 0;
    while (accepted < count) {
        const std::size_t begin = found.draws.size();
        if (begin > most * count + batch)
            throw std::runtime_error("too few plants of the family behave as published");
        found.draws.resize(begin + batch);
        operations::in_parallel(threads, batch, [&](std::size_t i) {
            found.draws[begin + i] = drawn(begin + i + 1, step_takes);
        });
        for (std::size_t i = begin; i < found.draws.size() && accepted < count; ++i) {
            if (!found.draws[i].as_published) continue;
            progress.advance();
            if (++accepted == count) found.draws.resize(i + 1);
        }
    }
    return found;
}

std::vector<std::string> DrawRow::names() {
    std::vector<std::string> list;
    for (const Uncertain& number : uncertain()) list.push_back(number.name);
    return list;
}

std::vector<DrawRow> rows_of(const Identification& identification, double step_takes,
                             unsigned threads) {
    std::vector<DrawRow> rows(identification.draws.size());
    operations::in_parallel(threads, rows.size(), [&](std::size_t i) {
        const Identification::Draw& draw = identification.draws[i];
        DrawRow& row = rows[i];
        row.plant = draw.seed;
        row.as_published = draw.as_published;
        row.fall_undamped_s = draw.fall;
        row.fall_damped_s = published(true).fall(draw.plant, step_takes);
        if (draw.swing > 0) row.swing_undamped_deg = draw.swing / degrees(1);
        Parameters plant = draw.plant, middle = published_parameters();
        for (const Uncertain& number : uncertain())
            row.numbers.push_back(number.of(plant) / number.of(middle));
    });
    return rows;
}

}  // namespace haptic::region
