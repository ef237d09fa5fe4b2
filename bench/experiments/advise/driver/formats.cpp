// SPDX-License-Identifier: GPL-3.0-or-later
// The user's program in the number formats FORMATS, X(integer bits, fraction bits) each, and in
// float: prints for each a line `format`, the events that Checked tells, and the pattern of each
// output.
#include <bit>
#include <cstdint>
#include <fixedpoint/arithmetic/checked.hpp>

#include "bench/experiments/advise/driver/run.hpp"

namespace {

struct Events {
    static unsigned long long overflows, underflows;
    static void notify(fixedpoint::Event event, fixedpoint::Operation) {
        ++(event == fixedpoint::Event::underflow ? underflows : overflows);
    }
};
unsigned long long Events::overflows, Events::underflows;

template <int I, int F>
void run_fixed(const std::vector<advise::Rows>& runs) {
    using Number = fixedpoint::Fixed<I, F, fixedpoint::Checked<Events>>;
    std::printf("format\t%d\t%d\n", I, F);
    Events::overflows = Events::underflows = 0;
    advise::run<Number>(
        runs, [](double x, std::size_t) { return fixedpoint::from_float<Number>(x); },
        [](Number output) { std::printf("output\t%lld\n", static_cast<long long>(output.raw())); });
    std::printf("events\t%llu\t%llu\n", Events::overflows, Events::underflows);
}

}  // namespace

int main(int, char** arguments) {
    const std::vector<advise::Rows> runs = advise::load_runs(arguments[1]);
#define X(integer_bits, fraction_bits) run_fixed<integer_bits, fraction_bits>(runs);
    FORMATS
#undef X
    std::printf("format\t0\t0\n");
    advise::run<float>(
        runs, [](double x, std::size_t) { return static_cast<float>(x); },
        [](float output) {
            std::printf("output\t%lld\n", static_cast<long long>(std::bit_cast<int32_t>(output)));
        });
    std::printf("events\t0\t0\n");
}
