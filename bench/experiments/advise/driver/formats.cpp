// SPDX-License-Identifier: GPL-3.0-or-later
// The user's program in float and in the number formats FORMATS, an X(integer bits, fraction bits)
// for each. Prints for each a line `format`, the events that Checked reports, how often each
// operation ran (a fused operation counts as one), and the pattern of each output.
#include <bit>
#include <cstdint>
#include <fixedpoint/arithmetic/checked.hpp>
#include <map>
#include <string>
#include <type_traits>

#include "bench/experiments/advise/driver/run.hpp"

namespace {

struct Events {
    static unsigned long long overflows, underflows;
    static void notify(fixedpoint::Event event, fixedpoint::Operation) {
        ++(event == fixedpoint::Event::underflow ? underflows : overflows);
    }
};
unsigned long long Events::overflows, Events::underflows;

std::map<std::string, unsigned long long> operations;

// The arithmetic, which counts its operations. On the chip, operations on constants cost nothing.
struct Counted : fixedpoint::Checked<Events> {
    using Base = fixedpoint::Checked<Events>;
#define COUNTED(name, ...)                                      \
    template <class Raw, int F, class... Operands>              \
    static constexpr auto name(Operands... operands) {          \
        if (!std::is_constant_evaluated()) ++operations[#name]; \
        return Base::template name<Raw, F>(operands...);        \
    }
    COUNTED(add)
    COUNTED(subtract)
    COUNTED(negate)
    COUNTED(multiply)
    COUNTED(divide)
    COUNTED(remainder)
    COUNTED(sqrt)
    COUNTED(reciprocal_sqrt)
    COUNTED(atan)
    COUNTED(atan2)
    COUNTED(sin)
    COUNTED(cos)
    COUNTED(sincos)
    COUNTED(exp)
    COUNTED(log)
    FIXEDPOINT_ELEMENTARY_FUNCTIONS(COUNTED)
    COUNTED(multiply_add)
    COUNTED(dot2)
    COUNTED(dot3)
    COUNTED(length2)
    COUNTED(length3)
    COUNTED(normalise3)
#undef COUNTED
};

template <int I, int F>
void run_fixed(const std::vector<advise::Rows>& runs) {
    using Number = fixedpoint::Fixed<I, F, Counted>;
    std::printf("format\t%d\t%d\n", I, F);
    Events::overflows = Events::underflows = 0;
    operations.clear();
    advise::run<Number>(
        runs, [](double x, std::size_t) { return fixedpoint::from_float<Number>(x); },
        [](Number output) { std::printf("output\t%lld\n", static_cast<long long>(output.raw())); });
    std::printf("events\t%llu\t%llu\n", Events::overflows, Events::underflows);
    for (const auto& [name, times] : operations)
        std::printf("operation\t%s\t%llu\n", name.c_str(), times);
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
