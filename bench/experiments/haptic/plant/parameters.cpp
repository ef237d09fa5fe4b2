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

Parameters varied(const Parameters& parameters, std::uint64_t seed) {
    Parameters p = parameters;
    Random random(seed);
    const auto vary = [&](double& number, double factor) { number *= random.log_uniform(factor); };
    vary(p.servo.no_load_speed, 1.2);
    vary(p.servo.stall_torque, 1.3);
    vary(p.servo.full_drive_error, 2);
    vary(p.servo.inertia, 2);
    vary(p.foam.stiffness, 1.5);
    vary(p.foam.hardening, 2);
    vary(p.foam.damping, 3);
    vary(p.foam.preload, 1.2);
    vary(p.lever.inertia, 1.5);
    vary(p.lever.friction, 3);
    vary(p.hand.stiffness, 3);
    vary(p.hand.damping, 3);
    vary(p.hand.mass, 3);
    for (double& gain : p.electrical.sensor_gain) vary(gain, 1.1);
    vary(p.electrical.sensor_lag, 2);
    vary(p.electrical.noise, 2);
    p.electrical.seed = seed;
    return p;
}

}  // namespace haptic
