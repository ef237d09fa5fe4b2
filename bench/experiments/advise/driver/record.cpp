// SPDX-License-Identifier: GPL-3.0-or-later
// The user's program with numbers that record. Called with a file of rows and formats (8.24), it
// prints lines of words: the number of inputs, each output in double, the operations, and the range
// of each variable and line with its overflows and underflows in the formats.
#include "bench/experiments/advise/driver/run.hpp"

namespace {

void print(const char* kind, const char* name, int line, const fixedpoint::Range& range,
           int formats, char** format) {
    std::printf("%s\t%s\t%d\t%llu\t%a\t%a\t%a\t%d", kind, name, line,
                static_cast<unsigned long long>(range.count()), range.least(), range.greatest(),
                range.smallest(), range.integer_bits());
    for (int i = 0; i < formats; ++i) {
        int integer_bits, fraction_bits;
        std::sscanf(format[i], "%d.%d", &integer_bits, &fraction_bits);
        std::printf("\t%llu\t%llu", static_cast<unsigned long long>(range.overflows(integer_bits)),
                    static_cast<unsigned long long>(range.underflows(fraction_bits)));
    }
    std::printf("\n");
}

}  // namespace

int main(int count, char** arguments) {
    using Number = fixedpoint::Recorded<double>;
    const std::vector<advise::Rows> runs = advise::load_runs(arguments[1]);
    std::printf("inputs\t%zu\n", advise::inputs_of_step<Number>);
    if (runs[0][0].size() != advise::inputs_of_step<Number>) return 0;
    std::vector<fixedpoint::Range> inputs(advise::inputs_of_step<Number>);
    fixedpoint::Range outputs;
    advise::run<Number>(
        runs,
        [&](double x, std::size_t i) {
            inputs[i].add(x);
            return Number(x);
        },
        [&](Number output) {
            outputs.add(double(output));
            std::printf("output\t%a\n", double(output));
        });
    const fixedpoint::Recording& recorded = fixedpoint::recording();
    for (const auto& [name, times] : recorded.operations)
        std::printf("operation\t%s\t%llu\n", name.c_str(), static_cast<unsigned long long>(times));
    const int formats = count - 2;
    for (std::size_t i = 0; i < inputs.size(); ++i)
        print("input", std::to_string(i + 1).c_str(), 0, inputs[i], formats, arguments + 2);
    print("result", "of step", 0, outputs, formats, arguments + 2);
    for (const auto& [name, range] : recorded.variables)
        print("variable", name.c_str(), 0, range, formats, arguments + 2);
    for (const auto& [place, range] : recorded.lines)
        print("line", place.first.c_str(), place.second, range, formats, arguments + 2);
}
