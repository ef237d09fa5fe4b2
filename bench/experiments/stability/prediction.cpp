// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/prediction.hpp"

#include <algorithm>
#include <cmath>

namespace stability {

double bits_to_overflow(double largest, double limit) {
    return largest > 0 ? std::log2(limit / largest) : std::log2(limit);
}

Prediction prediction_of(const Recorder& record, double limit) {
    double result = bits_to_overflow(record.result.largest, limit);
    // A double does not tell the end of 64 bits from the next number.
    if (record.first_failure()) result = std::min(result, -1e-6);
    return {bits_to_overflow(record.position.largest, limit),
            bits_to_overflow(record.velocity.largest, limit),
            bits_to_overflow(record.force.largest, limit), result};
}

std::optional<Prediction> predict(const Description& description, Split split,
                                  const std::string& integrator) {
    for (const auto& list : {subjects_of_any_format(split), more_subjects_of_any_format(split)})
        for (const Subject& one : list) {
            if (one.integrator != integrator) continue;
            const Outcome outcome =
                one.run(description, [](const State&, unsigned) { return true; });
            if (outcome.steps == 0) return {};
            return prediction_of(outcome.record, one.largest);
        }
    return {};
}

std::optional<Split> split_of(const Subject& subject) {
    if (subject.arithmetic != "nearest" || subject.ulp == 0) return {};
    const int fraction_bits = -std::ilogb(subject.ulp);
    const int width = static_cast<int>(std::lround(std::log2(subject.largest / subject.ulp))) + 1;
    return Split{width - fraction_bits, fraction_bits};
}

}  // namespace stability
