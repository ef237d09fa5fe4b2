// SPDX-License-Identifier: MIT
/// \file
/// Converted: the result of a conversion whose source may be outside the target's range.
#pragma once

namespace fixedpoint {
namespace portable {

/// The source rounded and saturated to the target's range, and whether it was in range.
template <class Target>
struct Converted {
    /// The target number: the rounded source, or the limit of the range that it exceeds.
    Target number;
    /// Whether the rounded source is in range.
    bool fits;
};

}  // namespace portable
}  // namespace fixedpoint
