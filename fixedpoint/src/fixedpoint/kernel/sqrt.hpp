// SPDX-License-Identifier: MIT
// The seam of sqrt: which code a format's square root runs through.
#pragma once

#include <fixedpoint/portable/sqrt.hpp>

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw sqrt(Raw a) {
    return portable::sqrt<Raw, F>(a);
}

}  // namespace kernel
}  // namespace fixedpoint
