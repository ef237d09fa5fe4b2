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

const char* name_of(fixedpoint::Operation operation) {
#define OPERATION_NAME(name, ...) #name,
    constexpr const char* names[] = {FIXEDPOINT_REPORTED_OPERATIONS(OPERATION_NAME)};
#undef OPERATION_NAME
    return names[static_cast<unsigned>(operation)];
}

std::string to_text(const Occurrence& occurrence) {
    constexpr const char* events[] = {"overflow", "division_by_zero", "domain_error", "underflow"};
    return fmt::format("{} {} {}", events[static_cast<unsigned>(occurrence.event)],
                       name_of(occurrence.operation), occurrence.quantity);
}

}  // namespace stability
