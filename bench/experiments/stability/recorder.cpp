// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/recorder.hpp"

#include <fmt/format.h>

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

std::string to_text(const Occurrence& occurrence) {
    constexpr const char* events[] = {"overflow", "division_by_zero", "domain_error", "underflow"};
    constexpr const char* operations[] = {
        "add",       "subtract",     "negate",       "multiply",  "divide",
        "remainder", "shift_left",   "convert",      "sqrt",      "reciprocal_sqrt",
        "log",       "multiply_add", "dot",          "length",    "scale_down",
        "cos",       "atan2",        "exp",          "normalise", "ceil",
        "round",     "from_float",   "from_decimal", "tan",       "asin",
        "acos",      "exp2",         "expm1",        "log2",      "log10",
        "log1p",     "sinh",         "cosh",         "tanh",      "cbrt",
        "pow"};
    return fmt::format("{} {} {}", events[static_cast<unsigned>(occurrence.event)],
                       operations[static_cast<unsigned>(occurrence.operation)],
                       occurrence.quantity);
}

}  // namespace stability
