// SPDX-License-Identifier: GPL-3.0-or-later
// Three numbers as a vector.
#pragma once

#include <array>

#include "reference/trajectories/state.hpp"

namespace reference {

using Vector3 = std::array<double, 3>;

inline Vector3 operator*(double factor, const Vector3& v) {
    return {factor * v[0], factor * v[1], factor * v[2]};
}
inline Vector3 operator+(const Vector3& a, const Vector3& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vector3 operator-(const Vector3& a, const Vector3& b) { return a + -1.0 * b; }
inline double dot(const Vector3& a, const Vector3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Throws std::invalid_argument if the times are not as trajectory.hpp requires.
void check(const Times& times);

}  // namespace reference
