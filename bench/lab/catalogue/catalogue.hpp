// SPDX-License-Identifier: GPL-3.0-or-later
// The rows of subjects.h as values.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "bench/lab/catalogue/subjects.h"
#include "reference/operation.hpp"

namespace catalogue {

enum class Provenance { ours, published, rival };

struct Implementation {
    std::string_view name;
    Provenance provenance;
};

#define IMPLEMENTATION_ROW(name, Policy, provenance, ...) \
    Implementation{#name, Provenance::provenance},
inline constexpr std::array implementations = {IMPLEMENTATIONS(IMPLEMENTATION_ROW)};
#undef IMPLEMENTATION_ROW

// Whether a wrong result is a failure. A rival's error is only measured. An implementation that is
// not in the catalogue, in somebody else's program, claims the definitions of its format.
inline bool is_held_to_its_definition(const reference::NamedSubject& named) {
    for (const Implementation& row : implementations)
        if (row.name == named.implementation) return row.provenance != Provenance::rival;
    return named.subject.format.kind == reference::FormatKind::fixed;
}

// The formats of the library.
inline std::vector<std::string> formats() {
#define FORMAT_NAME(format, ...) #format,
    return {LIBRARY_FORMATS(FORMAT_NAME)};
#undef FORMAT_NAME
}

// The device programs of the correctly rounded arithmetic.
inline std::vector<std::string> correctly_rounded_programs() {
    return {"correctly_rounded_angles",          "correctly_rounded_arcs",
            "correctly_rounded_powers",          "correctly_rounded_exponentials",
            "correctly_rounded_lengths_and_pow", "correctly_rounded_q8_24_angles",
            "correctly_rounded_q8_24_powers"};
}

// The device programs without their suffix: four for each format of the library, those of the
// correctly rounded arithmetic, one for numbers without a sign, one for the roundings, and the
// rivals'.
inline std::vector<std::string> programs() {
    std::vector<std::string> names;
    for (const std::string& format : formats())
        for (const char* part : {"", "_angles", "_powers", "_auxiliary"})
            names.push_back(format + part);
    for (const char* name : {"unsigned", "roundings", "rivals"}) names.emplace_back(name);
    for (const std::string& name : correctly_rounded_programs()) names.push_back(name);
    return names;
}

}  // namespace catalogue
