// SPDX-License-Identifier: MIT
/// \file
/// The haptic lever: a weight of 0.1 kg at the end of a virtual arm, felt through a servo. Two
/// opposed sensors measure the user's force, the engine moves the arm, and the servo follows the
/// arm's angle. The lever uses no hardware: readings come in and the servo's pulse goes out, so
/// that the same code runs on the chip, in tests and in a search for its limits.
///
///     Lever<LeverChoices<Q16_16>> lever;
///     Board::command_servo(lever.step(Board::readings(), BinaryStep<10>()));
///
/// Angles are the arm's, above its lower stop, in rad. Forces and speeds are positive upwards. All
/// units are SI. Values that depend only on the arm's length are computed when it changes.
#pragma once

#include <engine.h>
#include <math.h>

#include <firmware/calibration.hpp>
#include <firmware/frame_clock.hpp>
#include <firmware/hardware/readings.hpp>
#include <firmware/lever_frame_correction.hpp>
#include <firmware/lever_geometry.hpp>
#include <firmware/projection.hpp>

namespace firmware {

/// What a lever is made of: derive from it and hide the members that differ. It makes 2^rate steps
/// a second.
template <class ScalarType, int rate = 10>
struct LeverChoices {
    /// The number type of force, arm and pulse.
    using Scalar = ScalarType;
    /// The engine's scene that contains the arm.
    using Scene = scenes::Lever;
    /// The integrator and the solver.
    using Method = scenes::SemiImplicit;

    /// 1024.07 steps a second of 2^-10 s each: they differ by 64 ppm, as a resonator does from its
    /// frequency.
    static constexpr uint16_t step_length = ticks_per_second >> rate;  ///< ticks
    /// When a step is due.
    using Steps = FixedSteps<step_length>;
    /// The engine's step for that many ticks.
    static constexpr engine::BinaryStep<rate> time_step(uint16_t) { return {}; }

    /// The servo is told where the arm will be this much later, in s: the pulse that it follows is
    /// 10 ms old on average, and its drive takes another 10 ms. Without this, the servo, foam and
    /// sensors of a lever that is held still oscillate.
    static constexpr Scalar servo_delay() { return engine::Decimal<2, 2>(); }

    /// A user who pushes against the motion with more than 0.5 N slows it towards 0.5 N / push
    /// times its speed, by 2^-damping_exponent of the way in each step: within 2^-5 s. (Published
    /// as 0, all of the way, in steps of 10 ms; with 1000 steps a second that would stop a falling
    /// arm.)
    /// @{
    static constexpr bool selective_damping = true;
    static constexpr uint8_t damping_exponent = rate - 5;
    /// @}

    /// Whether to subtract the force that the sensors feel from the acceleration of their own
    /// frame: table D.2.
    static constexpr bool frame_correction = false;

    /// The smallest reading of one sensor at which the other may be free. It must be above the
    /// reading at rest, so that a sensor unplugged at rest is noticed. It must be below the reading
    /// of a sensor that holds the weight alone: otherwise a held lever loses its force whenever a
    /// foam lets go, and swings.
    static constexpr uint16_t pressed = 895;
};

/// The published device: its scene, method, clock and damping.
template <class ScalarType>
struct PublishedLeverChoices : LeverChoices<ScalarType> {
    /// As published.
    /// @{
    using Scene = scenes::PublishedLever;
    using Method = scenes::Published;
    using Steps = PublishedSteps;
    static constexpr ScalarType time_step(uint32_t ticks) { return seconds<ScalarType>(ticks); }
    static constexpr ScalarType servo_delay() { return ScalarType(); }
    static constexpr uint8_t damping_exponent = 0;
    /// @}
};

/// The lever, made of Choices.
template <class Choices>
class Lever {
  public:
    /// Its number type.
    using Scalar = typename Choices::Scalar;
    /// The engine's world that the arm is in.
    using World =
        engine::World<Scalar, typename Choices::Scene::template Uses<typename Choices::Method>>;
    /// A vector (x, y), with x to the right and y upwards.
    using Vector = typename World::Vector;
    /// The dimensions of the lever.
    using Geometry = LeverGeometry<Scalar>;

    /// Starts at rest on the lower stop, with the arm at its shortest.
    Lever() {
        typename Choices::Scene::template Parameters<Scalar> numbers{};
        numbers.length = Geometry::shortest();
        Choices::Scene::build(world_, numbers);
        set_length(Geometry::shortest());
        put_at(-Geometry::sine_of_stop());
        look();
    }

    /// Advances the arm by dt and returns the servo's pulse in ticks.
    template <class TimeStep>
    uint16_t step(const Readings& readings, TimeStep dt) {
        if (++steps_ % steps_per_dial_reading == 0) follow_dial(readings.sum[dial]);
        Scalar force = force_at_sensors(readings);
        if (Choices::frame_correction) force += frame_.correction(speed_ * inverse_length_, dt);
        const Scalar push = force * leverage_;
        pull_end(push * inverse_length_);
        if (Choices::selective_damping) damp(push);
        world_.step(dt);
        look();
        const Scalar angle = stop(this->angle());
        return pulse(angle + speed_ * lead_);
    }

    /// The arm's length, in m, which follows the dial.
    Scalar length() { return Arm::rod(world_).length; }
    /// Whether the last readings can be those of two connected sensors. If not, they count as no
    /// force.
    bool sensors_connected() const { return connected_; }

    /// Draws the arm. The grid's cells are 2.5 cm wide, so that the longest arm fits. The weight is
    /// a point: its radius of 1 cm is less than half a cell.
    template <class Grid>
    void draw(Grid& grid) {
        using Picture = Projection<Grid, typename Geometry::View>;
        const Vector& pivot = Arm::pivot(world_);
        const Vector& end = Arm::end(world_).position;
        const int16_t pivot_column = Picture::column(pivot[0]), pivot_row = Picture::row(pivot[1]);
        const int16_t column = Picture::column(end[0]), row = Picture::row(end[1]);
        grid.line(pivot_column, pivot_row, column, row, rod_colour);
        grid.point(pivot_column, pivot_row, pivot_colour);
        grid.point(column, row, weight_colour);
    }

  private:
    using Arm = ArmOf<typename Choices::Scene>;
    static constexpr uint8_t steps_per_dial_reading = 16;
    enum Colour : uint8_t { rod_colour = 1, pivot_colour = 3, weight_colour = 2 };

    // Updates the arm's position and speed from the world.
    void look() {
        const auto& end = Arm::end(world_);
        arm_ = end.position - Arm::pivot(world_);
        speed_ = arm_[1] * end.velocity[0] - arm_[0] * end.velocity[1];
    }

    // The user's force in newtons. Foam and frame keep the sensors' distance, so that one is free
    // only while the other is pressed hard: a sensor that reads nothing while the other is not
    // pressed is unplugged. No sensor reads the supply itself unless it is shorted.
    Scalar force_at_sensors(const Readings& readings) {
        const uint16_t a = readings.sum[sensor_a], b = readings.sum[sensor_b];
        connected_ = connected(a, b) && connected(b, a);
        if (!connected_) return Scalar();
        return (weight(a) - weight(b)) * Geometry::newtons_per_gram();
    }
    __attribute__((noinline)) static Scalar weight(uint16_t sum) { return grams<Scalar, 1>(sum); }
    static bool connected(uint16_t sum, uint16_t other) {
        constexpr uint16_t free = 2 * 8, pressed = 2 * Choices::pressed, shorted = 2 * 1018;
        return sum < shorted && (sum > free || other > pressed);
    }

    // Applies a force perpendicular to the arm: `per_metre` times its length.
    void pull_end(Scalar per_metre) {
        Vector& force = world_.custom_force().force;
        force[0] = arm_[1] * per_metre;
        force[1] = -(arm_[0] * per_metre);
    }

    void damp(Scalar push) {
        const Scalar against = speed_ < Scalar() ? push : -push;
        const Scalar tolerated = engine::Decimal<5, 1>();
        if (!(against > tolerated)) return;
        constexpr engine::BinaryStep<Choices::damping_exponent> share;
        const Scalar kept = Geometry::one() - Geometry::one() * share;
        Arm::end(world_).velocity *= kept + tolerated * share / against;
    }

    // Measured from straight down, where the arm never is, so that (-pi, pi] and [0, 2 pi) give the
    // same.
    Scalar angle() const {
        using ::atan2;
        return Scalar(atan2(-arm_[0], -arm_[1])) - Geometry::lower_stop_from_below();
    }

    // Keeps the arm between its stops, off which it bounces.
    __attribute__((noinline)) Scalar stop(Scalar angle) {
        const bool low = angle < Scalar();
        if (!low && !(angle > Geometry::travel())) return angle;
        put_at(low ? Scalar(-Geometry::sine_of_stop()) : Geometry::sine_of_stop());
        if (low ? speed_ < Scalar() : speed_ > Scalar())
            Arm::end(world_).velocity *= Geometry::bounce();
        look();
        return low ? Scalar() : Geometry::travel();
    }
    void put_at(Scalar sine) {
        Vector& position = Arm::end(world_).position;
        position = Arm::pivot(world_);
        position[0] -= Geometry::cosine_of_stop() * length();
        position[1] += sine * length();
    }

    static uint16_t pulse(Scalar angle) {
        return static_cast<uint16_t>(
            Geometry::pulse_at_lower_stop +
            CellArithmetic<Scalar>::nearest(angle * Geometry::ticks_per_radian()));
    }

    // Moves the length a quarter of the way each time: 55 ms. The angle and its rate do not change.
    void follow_dial(uint16_t sum) {
        const Scalar quarter = engine::Decimal<25, 2>();
        const Scalar change = (Geometry::length_at(sum) - length()) * quarter;
        if (change == Scalar()) return;
        const Scalar longer = length() + change;
        const Scalar ratio = longer * inverse_length_;
        auto& end = Arm::end(world_);
        end.position = Arm::pivot(world_) + arm_ * ratio;
        end.velocity *= ratio;
        set_length(longer);
        look();
    }
    void set_length(Scalar length) {
        world_.set_length(Arm::rod(world_), length);
        inverse_length_ = Geometry::one() / length;
        leverage_ = Geometry::sensor_radius() * inverse_length_;
        lead_ = Choices::servo_delay() * inverse_length_ * inverse_length_;
    }

    Scalar inverse_length_;  // 1 / m; the first member, where a debugger finds it
    World world_;
    Vector arm_;       // from the pivot to the weight
    Scalar speed_;     // of the weight, upwards, times the arm's length
    Scalar leverage_;  // force at the weight by force at the sensors
    Scalar lead_;      // servo_delay / length^2
    FrameCorrection<Scalar, Choices::frame_correction> frame_;
    uint8_t steps_ = 0;
    bool connected_ = true;
};

}  // namespace firmware
