// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/recorder.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace stability {

Recorder*& active_recorder() {
    static thread_local Recorder* recorder = nullptr;
    return recorder;
}

const char* name_of(engine::Quantity quantity) {
    constexpr const char* names[] = {"description", "spring_force", "drag_force", "custom_force",
                                     "velocity",    "position",     "damping",    "rod",
                                     "rope",        "plane",        "contact",    "resolution"};
    return names[static_cast<unsigned>(quantity)];
}

// The compiler names a case that is missing.
const char* name_of(fixedpoint::Operation operation) {
    using fixedpoint::Operation;
#define FIXBENCH_NAME(name) \
    case Operation::name:   \
        return #name
    switch (operation) {
        FIXBENCH_NAME(add);
        FIXBENCH_NAME(subtract);
        FIXBENCH_NAME(negate);
        FIXBENCH_NAME(multiply);
        FIXBENCH_NAME(divide);
        FIXBENCH_NAME(remainder);
        FIXBENCH_NAME(shift_left);
        FIXBENCH_NAME(convert);
        FIXBENCH_NAME(sqrt);
        FIXBENCH_NAME(reciprocal_sqrt);
        FIXBENCH_NAME(log);
        FIXBENCH_NAME(multiply_add);
        FIXBENCH_NAME(dot);
        FIXBENCH_NAME(length);
        FIXBENCH_NAME(scale_down);
        FIXBENCH_NAME(cos);
        FIXBENCH_NAME(atan2);
        FIXBENCH_NAME(exp);
        FIXBENCH_NAME(normalise);
        FIXBENCH_NAME(ceil);
        FIXBENCH_NAME(round);
        FIXBENCH_NAME(from_float);
        FIXBENCH_NAME(from_decimal);
        FIXBENCH_NAME(tan);
        FIXBENCH_NAME(asin);
        FIXBENCH_NAME(acos);
        FIXBENCH_NAME(exp2);
        FIXBENCH_NAME(expm1);
        FIXBENCH_NAME(log2);
        FIXBENCH_NAME(log10);
        FIXBENCH_NAME(log1p);
        FIXBENCH_NAME(sinh);
        FIXBENCH_NAME(cosh);
        FIXBENCH_NAME(tanh);
        FIXBENCH_NAME(cbrt);
        FIXBENCH_NAME(pow);
        FIXBENCH_NAME(lerp);
        FIXBENCH_NAME(power);
    }
#undef FIXBENCH_NAME
    throw std::logic_error("an event of no operation");
}

std::string to_text(const Occurrence& occurrence) {
    constexpr const char* events[] = {"overflow", "division_by_zero", "domain_error", "underflow"};
    return fmt::format("{} {} {}", events[static_cast<unsigned>(occurrence.event)],
                       name_of(occurrence.operation), occurrence.quantity);
}

}  // namespace stability
