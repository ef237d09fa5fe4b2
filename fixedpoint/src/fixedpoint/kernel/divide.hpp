// SPDX-License-Identifier: MIT
// The seam of divide: which code a format's quotient runs through.
#pragma once

#include <fixedpoint/portable/divide.hpp>

namespace fixedpoint {
namespace kernel {

template <class Raw, int F>
constexpr Raw divide(Raw a, Raw b) {
    return portable::divide<Raw, F>(a, b);
}

}  // namespace kernel
}  // namespace fixedpoint
