// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the user's program on the host.
#pragma once

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "bench/experiments/advise/driver/program.hpp"

namespace advise {

template <class Number, class... Inputs>
constexpr std::size_t count_inputs(Number (Program<Number>::*)(Inputs...)) {
    return sizeof...(Inputs);
}
template <class Number>
constexpr std::size_t inputs_of_step = count_inputs<Number>(&Program<Number>::step);

// Runs, each of which starts with a new program; rows of inputs.
using Rows = std::vector<std::vector<double>>;

// One row per line, and an empty line after each run.
inline std::vector<Rows> load_runs(const char* path) {
    std::vector<Rows> runs;
    std::FILE* const file = std::fopen(path, "r");
    if (file == nullptr) std::exit(1);
    bool fresh = true;
    std::vector<double> row;
    for (double x; std::fscanf(file, "%lf", &x) == 1;) {
        if (std::exchange(fresh, false)) runs.emplace_back();
        row.push_back(x);
        if (std::getc(file) != '\n') continue;
        runs.back().push_back(std::exchange(row, {}));
        const int next = std::getc(file);
        fresh = next == '\n';
        if (!fresh) std::ungetc(next, file);
    }
    std::fclose(file);
    return runs;
}

template <class Number, std::size_t... i>
Number step(Program<Number>& program, const Number* inputs, std::index_sequence<i...>) {
    return program.step(inputs[i]...);
}

// Calls use(output) for the output of each row; number(x, i) converts the i-th input.
template <class Number, class ToNumber, class Use>
void run(const std::vector<Rows>& runs, ToNumber&& number, Use&& use) {
    constexpr std::size_t inputs = inputs_of_step<Number>;
    for (const Rows& rows : runs) {
        Program<Number> program;
        for (const std::vector<double>& row : rows) {
            std::array<Number, inputs> numbers{};
            for (std::size_t i = 0; i < inputs; ++i) numbers[i] = number(row[i], i);
            use(step(program, numbers.data(), std::make_index_sequence<inputs>()));
        }
    }
}

}  // namespace advise
