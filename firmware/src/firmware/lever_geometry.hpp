// SPDX-License-Identifier: MIT
/// \file
/// The dimensions of the haptic lever, and where each scene keeps its arm.
#pragma once

#include <firmware/hardware/readings.hpp>
#include <fixedpoint/arithmetic/small.hpp>
#include <scenes/lever.hpp>
#include <scenes/published_lever.hpp>

namespace firmware {

/// Nearest, except for its arc tangent, which takes less flash and more cycles: `fixbench cycles
/// --operation atan2`.
struct LeverArithmetic : fixedpoint::Nearest {
    /// The arc tangent of Small.
    template <class Raw, int F>
    static constexpr Raw atan2(Raw y, Raw x) {
        return fixedpoint::Small::atan2<Raw, F>(y, x);
    }
};
/// The number type of the lever that is flashed.
using LeverScalar = fixedpoint::Fixed<16, 16, LeverArithmetic>;

/// The arm points to the left of its pivot and moves from 30 degrees below the horizontal to 30
/// degrees above it: 60 degrees of the servo. The servo's shortest pulse belongs to the lower stop.
template <class ScalarType>
struct LeverGeometry {
    /// The number type.
    using Scalar = ScalarType;
    /// A decimal constant.
    template <int64_t digits, unsigned char places>
    using Decimal = engine::Decimal<digits, places>;

    /// The number 1.
    static constexpr Scalar one() { return Decimal<1, 0>(); }

    static constexpr Scalar lower_stop_from_below() { return Decimal<10471976, 7>(); }  ///< rad
    static constexpr Scalar travel() { return Decimal<10471976, 7>(); }                 ///< rad
    /// The cosine of the angle between a stop and the horizontal.
    static constexpr Scalar cosine_of_stop() { return Decimal<8660254, 7>(); }
    /// The sine of the angle between a stop and the horizontal.
    static constexpr Scalar sine_of_stop() { return Decimal<5, 1>(); }

    /// The velocity after a bounce off a stop, relative to the velocity before.
    static constexpr Scalar bounce() { return -Decimal<5, 1>(); }

    /// The pulse in ticks at the lower stop. For a hobby servo 1 ms is 90 degrees.
    static constexpr uint16_t pulse_at_lower_stop = 1000 * ticks_per_microsecond;
    /// The change of the servo's pulse in ticks per radian.
    static constexpr Scalar ticks_per_radian() { return Decimal<12732395, 4>(); }

    static constexpr Scalar sensor_radius() { return Decimal<4, 2>(); }  ///< of the sensors, m
    /// The weight of a gram in N.
    static constexpr Scalar newtons_per_gram() { return Decimal<980665, 8>(); }

    /// The arm's length in m at one end of the dial. At the other it is 0.25 m more.
    static constexpr Scalar shortest() { return Decimal<23, 2>(); }
    /// The arm's length in m for the sum of two readings of the dial.
    static Scalar length_at(uint16_t sum) {
        return shortest() + calibration::scaled<Scalar, 11>(sum) * longer();
    }

    /// The view of the screen: 0.5 m on each side, 2.5 cm a cell.
    struct View {
        /// The members that Projection requires.
        /// @{
        using Scalar = ScalarType;
        static constexpr uint16_t cells_per_unit = 40;
        static constexpr Scalar left() { return -Decimal<11, 2>(); }
        static constexpr Scalar bottom() { return -Decimal<1, 1>(); }
        static constexpr Scalar slice() { return Decimal<0, 0>(); }
        /// @}
    };

  private:
    // 0.25 m at 2046 of 2048.
    static constexpr Scalar longer() { return Decimal<2502444, 7>(); }
};

/// \cond internal
// The rod, its moving end and its fixed end.
template <class Scene>
struct ArmOf;
template <>
struct ArmOf<scenes::Lever> {
    template <class World>
    static const typename World::AnchoredRod& rod(World& world) {
        return world.anchored_rods()[0];
    }
    template <class World>
    static typename World::Particle& end(World& world) {
        return world.particles()[0];
    }
    template <class World>
    static const typename World::Vector& pivot(World& world) {
        return rod(world).ends.anchor;
    }
};
template <>
struct ArmOf<scenes::PublishedLever> {
    template <class World>
    static const typename World::Rod& rod(World& world) {
        return world.rods()[0];
    }
    template <class World>
    static typename World::Particle& end(World& world) {
        return world.particles()[1];
    }
    template <class World>
    static const typename World::Vector& pivot(World& world) {
        return world.particles()[0].position;
    }
};
/// \endcond

}  // namespace firmware
