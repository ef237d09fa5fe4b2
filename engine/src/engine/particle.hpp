// SPDX-License-Identifier: MIT
/// \file
/// A particle: a sphere that does not rotate. It stores what its scene uses and no more.
#pragma once

#include <engine/decimal.hpp>
#include <engine/time_step.hpp>
#include <engine/vector.hpp>

namespace engine {

/// \cond internal
template <class Vector, bool used>
struct Force {};
template <class Vector>
struct Force<Vector, true> {
    Vector force;  // N, of this step
};

template <class Scalar, bool used>
struct Radius {};
template <class Scalar>
struct Radius<Scalar, true> {
    Scalar radius = Scalar();  // m
};

template <class Scalar, bool used>
struct Damping {};
template <class Scalar>
struct Damping<Scalar, true> {
    Scalar damping = Scalar();  // factor of the velocity in each step
};

template <class Vector, bool used>
struct WayBack {};
template <class Vector>
struct WayBack<Vector, true> {
    Vector way_back;  // m, to where it was before the solver moved it in this step
};

// Members that a particle may not have. These overloads are only declared then, since nothing calls
// them.
template <class Scalar>
Scalar& radius_of(Radius<Scalar, true>& particle) {
    return particle.radius;
}
template <class Scalar>
Scalar& radius_of(Radius<Scalar, false>&);
template <class Scalar>
Scalar& damping_of(Damping<Scalar, true>& particle) {
    return particle.damping;
}
template <class Scalar>
Scalar& damping_of(Damping<Scalar, false>&);
template <class Vector>
Vector& force_of(Force<Vector, true>& particle) {
    return particle.force;
}
template <class Vector>
Vector& force_of(Force<Vector, false>&);
template <class Scalar>
const Scalar& radius_of(const Radius<Scalar, true>& particle) {
    return particle.radius;
}
template <class Scalar>
const Scalar& radius_of(const Radius<Scalar, false>&);

// Adds rate * dt to a vector. With residuals, the part below one ulp is carried to the next step.
template <class Vector, bool exact>
struct Residuals {
    template <class TimeStep>
    static ENGINE_INLINE void move(Vector& position, const Vector& velocity, TimeStep dt) {
        position.add_scaled(velocity, dt);
    }
    template <class TimeStep>
    static ENGINE_INLINE void accelerate(Vector& velocity, const Vector& acceleration,
                                         TimeStep dt) {
        velocity.add_scaled(acceleration, dt);
    }
};
template <class Vector>
struct Residuals<Vector, true> {
    Vector position_residual, velocity_residual;  // less than one ulp of each, times 2^K

    template <class TimeStep>
    void move(Vector& position, const Vector& velocity, TimeStep dt) {
        carry(position, velocity, dt, position_residual);
    }
    template <class TimeStep>
    void accelerate(Vector& velocity, const Vector& acceleration, TimeStep dt) {
        carry(velocity, acceleration, dt, velocity_residual);
    }

  private:
    template <class TimeStep>
    static void carry(Vector& sum, const Vector& rate, TimeStep dt, Vector& residual) {
        for (unsigned char i = 0; i < sizeof sum / sizeof sum[0]; ++i) {
            sum[i] += carried_product(rate[i], dt, residual[i]);
        }
    }
};
/// \endcond

/// The description that add_particle makes a particle from. Members that the scene does not use are
/// ignored.
template <class Scalar, int N>
struct Body {
    Vector<Scalar, N> position;        ///< m
    Vector<Scalar, N> velocity;        ///< m/s
    Scalar inverse_mass = Scalar();    ///< 1/kg; 0 is immovable
    Scalar radius = Scalar();          ///< m
    Scalar damping = Decimal<1, 0>();  ///< factor of the velocity in each step
};

/// A particle of a world. It has the members `force`, `radius`, `damping` and `way_back` if the
/// scene uses them.
template <class Scalar, class Uses, bool forces, bool way_back>
struct Particle : Force<Vector<Scalar, Uses::dimensions>, forces>,
                  Radius<Scalar, Uses::radii>,
                  Damping<Scalar, Uses::damping>,
                  WayBack<Vector<Scalar, Uses::dimensions>, way_back>,
                  Residuals<Vector<Scalar, Uses::dimensions>, Uses::compensated_integration> {
    Vector<Scalar, Uses::dimensions> position;  ///< m
    Vector<Scalar, Uses::dimensions> velocity;  ///< m/s
    Scalar inverse_mass = Scalar();             ///< 1/kg; 0 is immovable
};

/// Whether the particle can move: its inverse mass is above 0.
template <class Particle>
constexpr bool movable(const Particle& particle) {
    return particle.inverse_mass > decltype(particle.inverse_mass)();
}

}  // namespace engine
