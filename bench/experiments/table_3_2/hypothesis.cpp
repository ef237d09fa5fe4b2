// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/table_3_2/hypothesis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "bench/lab/parallel.hpp"
#include "bench/lab/records/csv.hpp"
#include "reference/published.hpp"

namespace table_3_2 {

namespace {

// Fits whose sums over all rows differ by less than this count as equal: a third of a percent per
// row.
constexpr double tie = 0.1;

bool leaves_early(const Operands& operands) {
    return operands.real.b == 0 || std::abs(operands.real.a * operands.real.b) > 3.4e38;
}

std::vector<Fit> fits_of(const Program& program, const std::vector<Published>& published) {
    std::vector<Fit> fits;
    Harness harness(program.elf);
    for (const std::string& form : forms()) {
        for (const Operands& operands : operand_pairs()) {
            Fit fit{{program, form, operands}};
            for (const Published& row : published) {
                const double ratio = quick_ms(harness, fit.hypothesis, row.cell) / row.ms;
                fit.log_ratio_sum += std::abs(std::log(ratio));
                fit.within_10_percent += reference::within_10_percent(ratio);
            }
            fits.push_back(fit);
        }
    }
    return fits;
}

}  // namespace

std::vector<Published> load_published() {
    std::vector<Published> published;
    for (const auto load : {reference::load_table_3_2, reference::load_functions})
        for (const reference::PublishedTiming& row : load(reference::published_folder()))
            published.push_back({{row.type, row.operation}, row.milliseconds});
    return published;
}

std::vector<Program> load_programs(const std::filesystem::path& programs_csv) {
    std::vector<Program> programs;
    const records::Table table = records::Table::load(programs_csv);
    for (const auto& row : table.rows()) {
        const auto at = [&](const char* column) { return row[table.column(column)]; };
        programs.push_back(
            {at("elf"), at("flags"), at("loop"), at("operators"), at("shift"), at("widening")});
    }
    return programs;
}

std::array<std::string, axes.size()> values(const Hypothesis& h) {
    return {
        h.form,          h.operands.name(), h.program.flags, h.program.loop, h.program.operators,
        h.program.shift, h.program.widening};
}

std::vector<std::size_t> differences(const Hypothesis& a, const Hypothesis& b) {
    std::vector<std::size_t> different;
    for (std::size_t axis = 0; axis < axes.size(); ++axis) {
        if (values(a)[axis] != values(b)[axis]) different.push_back(axis);
    }
    return different;
}

bool is_alternative(const Hypothesis& best, const Hypothesis& other) {
    const std::size_t changes = differences(best, other).size();
    return changes == 1 || (changes == 2 && other.form != best.form);
}

const std::vector<std::string>& forms() {
    static const std::vector<std::string> forms{"assign", "accumulate", "replace"};
    return forms;
}

const std::vector<Operands>& operand_pairs() {
    static const std::vector<Operands> pairs{
        // Numbers that anybody might type.
        {{7, 3}, {3.75, 1.25}, false},
        {{100, 7}, {12.5, 0.38}, false},
        {{1000, 3}, {100, 3}, false},
        // The same integers in every type, as raw values in the fixed-point types: quotients of
        // two, three and four bytes before the shift.
        {{1000, 3}, {3.75, 1.25}, true},
        {{30000, 7}, {3.75, 1.25}, true},
        {{1000000, 3}, {3.75, 1.25}, true},
        {{10000000, 3}, {3.75, 1.25}, true},
        {{123456789, 1000}, {12.5, 0.38}, true},
        {{2000000000, 1000}, {3.75, 1.25}, true},
        {{2000000000, 7}, {3.75, 1.25}, true},
        {{16777215, 1}, {3.75, 1.25}, true},
        {{2147483647, 128}, {3.75, 1.25}, true},
        // Floating-point operands with an early exit: a zero divisor, an overflow.
        {{1000000, 3}, {3.75, 0}, true},
        {{1000000, 3}, {1e30, 1e30}, true},
    };
    return pairs;
}

double quick_ms(Harness& harness, const Hypothesis& hypothesis, const Cell& cell) {
    // Floating-point sums change from pass to pass.
    const int passes = cell.type == "float" ? 24 : 3;
    return undisturbed_ms(harness.cycles(hypothesis.form, cell, hypothesis.operands, passes));
}

std::vector<Fit> search(const std::vector<Program>& programs,
                        const std::vector<Published>& published,
                        const std::function<void()>& program_done) {
    std::vector<std::vector<Fit>> found(programs.size());
    operations::in_parallel(2, programs.size(), [&](std::size_t i) {
        found[i] = fits_of(programs[i], published);
        program_done();
    });
    std::vector<Fit> fits;
    for (const auto& some : found) fits.insert(fits.end(), some.begin(), some.end());
    // Equal fits are ordered by their values.
    std::sort(fits.begin(), fits.end(), [](const Fit& a, const Fit& b) {
        return std::pair(a.log_ratio_sum, values(a.hypothesis)) <
               std::pair(b.log_ratio_sum, values(b.hypothesis));
    });
    return fits;
}

const Fit& preferred(const std::vector<Fit>& fits) {
    const Fit* best = nullptr;
    for (const Fit& fit : fits) {
        const Hypothesis& h = fit.hypothesis;
        if (leaves_early(h.operands)) continue;
        if (!best) best = &fit;
        if (fit.log_ratio_sum > best->log_ratio_sum + tie) break;
        if (h.program.flags == "-Os" && h.program.loop == "int") return fit;
    }
    if (!best) throw std::invalid_argument("no hypothesis to prefer");
    return *best;
}

Hypothesis best_known(const std::vector<Program>& programs) {
    for (const Program& program : programs) {
        if (program.flags == "-Os" && program.loop == "int" && program.operators == "constructed" &&
            program.shift == "variable" && program.widening == "after") {
            return {program, "accumulate", {{1000000, 3}, {3.75, 1.25}, true}};
        }
    }
    throw std::runtime_error("the program of the best hypothesis was not built");
}

}  // namespace table_3_2
