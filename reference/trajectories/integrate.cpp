// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/trajectories/integrate.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <memory>
#include <stdexcept>
#include <string>

namespace reference {

std::vector<Variables> integrate(const Derivative& derivative, const Variables& start,
                                 const std::vector<double>& times, double tolerance) {
    constexpr double first_step = 1e-4;  // s
    const auto call = [](double, const double* variables, double* rates, void* function) {
        (*static_cast<const Derivative*>(function))(variables, rates);
        return static_cast<int>(GSL_SUCCESS);
    };
    gsl_odeiv2_system system = {call, nullptr, start.size(), const_cast<Derivative*>(&derivative)};
    const std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> driver(
        gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, first_step, tolerance,
                                      tolerance),
        gsl_odeiv2_driver_free);
    std::vector<Variables> solution;
    Variables variables = start;
    double now = 0;
    for (double time : times) {
        const int status = gsl_odeiv2_driver_apply(driver.get(), &now, time, variables.data());
        if (status != GSL_SUCCESS)
            throw std::runtime_error(std::string("integration failed: ") + gsl_strerror(status));
        solution.push_back(variables);
    }
    return solution;
}

}  // namespace reference
