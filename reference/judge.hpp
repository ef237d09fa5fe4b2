// SPDX-License-Identifier: GPL-3.0-or-later
// Judges one result of any subject against the exact value: any format, any operands, a few
// microseconds each. bulk.hpp judges the formats of 8 to 32 bits some hundred times faster.
#pragma once

#include <cstdint>
#include <span>

#include "reference/definition.hpp"
#include "reference/judgement.hpp"

namespace reference {

// `operands` and `results` are raws, as many as shape(subject.operation) states; throws
// std::invalid_argument for any other number of them. The sign of a float zero is not judged.
Judgement judge(const Subject& subject, std::span<const std::int64_t> operands,
                std::span<const std::int64_t> results);

inline Judgement judge(const Subject& subject, std::span<const std::int64_t> operands,
                       std::int64_t result) {
    return judge(subject, operands, std::span(&result, 1));
}

}  // namespace reference
