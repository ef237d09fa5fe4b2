// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/cost/growth/fit.hpp"

#include <gsl/gsl_multifit.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <stdexcept>

namespace growth {

Fit fitted(const std::vector<Sample>& samples) {
    constexpr std::size_t terms = 3;
    const std::size_t points = samples.size();
    if (points <= terms) throw std::runtime_error("a fit needs four numbers of particles");
    const auto matrix = [](std::size_t rows, std::size_t columns) {
        return std::unique_ptr<gsl_matrix, void (*)(gsl_matrix*)>(gsl_matrix_alloc(rows, columns),
                                                                  gsl_matrix_free);
    };
    const auto vector = [](std::size_t size) {
        return std::unique_ptr<gsl_vector, void (*)(gsl_vector*)>(gsl_vector_alloc(size),
                                                                  gsl_vector_free);
    };
    const auto powers = matrix(points, terms), covariance = matrix(terms, terms);
    const auto weights = vector(points), values = vector(points), solution = vector(terms);
    for (std::size_t i = 0; i < points; ++i) {
        const auto [n, grown, value] = samples[i];
        gsl_matrix_set(powers.get(), i, 0, 1);
        gsl_matrix_set(powers.get(), i, 1, n);
        gsl_matrix_set(powers.get(), i, 2, grown);
        gsl_vector_set(weights.get(), i, 1 / (value * value));
        gsl_vector_set(values.get(), i, value);
    }
    const std::unique_ptr<gsl_multifit_linear_workspace, void (*)(gsl_multifit_linear_workspace*)>
        workspace(gsl_multifit_linear_alloc(points, terms), gsl_multifit_linear_free);
    double square = 0;
    gsl_multifit_wlinear(powers.get(), weights.get(), values.get(), solution.get(),
                         covariance.get(), &square, workspace.get());
    Fit fit{gsl_vector_get(solution.get(), 0), gsl_vector_get(solution.get(), 1),
            gsl_vector_get(solution.get(), 2), 0};
    for (const Sample& sample : samples)
        fit.worst = std::max(fit.worst, std::abs(fit(sample) / sample.value - 1));
    return fit;
}

std::vector<Cost> of_search(const std::vector<Cost>& costs, const std::string& search) {
    std::vector<Cost> chosen;
    std::copy_if(costs.begin(), costs.end(), std::back_inserter(chosen),
                 [&](const Cost& cost) { return cost.broad_phase == search; });
    return chosen;
}

std::optional<unsigned> crossing(const std::vector<Cost>& first, const std::vector<Cost>& second) {
    std::optional<unsigned> from;
    for (std::size_t i = 0; i < std::min(first.size(), second.size()); ++i) {
        if (second[i].per_step > first[i].per_step)
            from.reset();
        else if (!from)
            from = first[i].particles;
    }
    return from;
}

}  // namespace growth
