// SPDX-License-Identifier: GPL-3.0-or-later
// Judges the operations of every split, millions per second. reference/bulk.hpp judges subjects
// that are known at compile time; here the width is known, but not the position of the point.
#pragma once

#include <cstdint>
#include <span>

#include "reference/judgement.hpp"
#include "reference/operation.hpp"

namespace judge {

using SplitJudge = reference::Judgement (*)(const reference::NumberFormat& format,
                                            std::span<const std::int64_t> operands,
                                            std::span<const std::int64_t> results);

// Judges as reference::judge does, functions with an error below 2^-14 ulp. Null for a subject
// without such a judge: another arithmetic than the default, functions of 64 bits, results that are
// vectors, shifts and conversions.
SplitJudge split_judge(const reference::Subject& subject);

}  // namespace judge
