// SPDX-License-Identifier: MIT
/// \file
/// Converted: what a conversion that may leave the range of its target returns.
#pragma once

namespace fixedpoint {
namespace portable {

/// The target number nearest to the source, and whether the source, rounded, is that number. Where
/// it is not, the number is the limit of the target's range that the source lies beyond.
template <class Target>
struct Converted {
    /// The target number.
    Target number;
    /// Whether the source, rounded, is it.
    bool fits;
};

}  // namespace portable
}  // namespace fixedpoint
