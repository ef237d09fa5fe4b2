// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/haptic/plant/parameters.hpp"

#include "bench/experiments/haptic/plant/random.hpp"
#include "reference/published.hpp"

namespace haptic {

Parameters published_parameters() {
    Parameters parameters;
    for (const reference::ForceCalibration& row : reference::load_table_d_1())
        parameters.sensor.push_back({row.actual_grams * 1e-3 * 9.80665, row.adc_reading});
    return parameters;
}

const std::vector<Uncertain>& uncertain() {
    using P = Parameters;
    static const std::vector<Uncertain> list{
        {"servo_no_load_speed", 1.2, [](P& p) -> double& { return p.servo.no_load_speed; }},
        {"servo_stall_torque", 1.3, [](P& p) -> double& { return p.servo.stall_torque; }},
        {"servo_full_drive_error", 2, [](P& p) -> double& { return p.servo.full_drive_error; }},
        {"servo_inertia", 2, [](P& p) -> double& { return p.servo.inertia; }},
        {"foam_stiffness", 1.5, [](P& p) -> double& { return p.foam.stiffness; }},
        {"foam_hardening", 2, [](P& p) -> double& { return p.foam.hardening; }},
        {"foam_damping", 3, [](P& p) -> double& { return p.foam.damping; }},
        {"foam_preload", 1.2, [](P& p) -> double& { return p.foam.preload; }},
        {"lever_inertia", 1.5, [](P& p) -> double& { return p.lever.inertia; }},
        {"lever_friction", 3, [](P& p) -> double& { return p.lever.friction; }},
        {"hand_stiffness", 3, [](P& p) -> double& { return p.hand.stiffness; }},
        {"hand_damping", 3, [](P& p) -> double& { return p.hand.damping; }},
        {"hand_mass", 3, [](P& p) -> double& { return p.hand.mass; }},
        {"sensor_gain_0", 1.1, [](P& p) -> double& { return p.electrical.sensor_gain[0]; }},
        {"sensor_gain_1", 1.1, [](P& p) -> double& { return p.electrical.sensor_gain[1]; }},
        {"sensor_lag", 2, [](P& p) -> double& { return p.electrical.sensor_lag; }},
        {"noise", 2, [](P& p) -> double& { return p.electrical.noise; }},
    };
    return list;
}

Parameters varied(const Parameters& parameters, std::uint64_t seed) {
    Parameters p = parameters;
    Random random(seed);
    for (const Uncertain& number : uncertain()) number.of(p) *= random.log_uniform(number.factor);
    p.electrical.seed = seed;
    return p;
}

}  // namespace haptic
