// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/table_3_2/division.hpp"

#include <fmt/format.h>
#include <gsl/gsl_multifit.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <random>

#include "bench/chip/simulator/device_function.hpp"

namespace table_3_2 {

namespace {

constexpr std::size_t terms = 7;

std::array<double, terms> terms_of(std::int32_t a, std::int32_t b) {
    const std::uint64_t quotient = published_quotient(a, b);
    return {1.0,
            static_cast<double>(quotient_bytes(a, b)),
            static_cast<double>(std::popcount(quotient)),
            a < 0 ? 1.0 : 0.0,
            b < 0 ? 1.0 : 0.0,
            a < 0 && b < 0 ? 1.0 : 0.0,
            quotient == 0 ? 1.0 : 0.0};
}

// A random operand of a class; never 0.
class Draw {
  public:
    std::int32_t operator()(const std::string& operands) {
        std::int64_t raw = 0;
        while (raw == 0) {
            double value = 0;
            if (operands == "small") value = uniform(-1, 1) * 65536;
            if (operands == "physics") value = sign() * log_uniform(0.01, 20) * 65536;
            if (operands == "full") value = sign() * log_uniform(1, 2147483647);
            raw = std::llround(value);
        }
        return static_cast<std::int32_t>(raw);
    }

  private:
    // Written out, since the distributions of standard libraries differ.
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
    }
    double log_uniform(double low, double high) {
        return std::exp(uniform(std::log(low), std::log(high)));
    }
    double sign() { return random_() & 1 ? -1 : 1; }
    std::mt19937_64 random_{32};
};

void add_histogram(std::vector<DivisionRow>& rows, const std::string& kind,
                   const std::string& operands, const std::vector<std::uint32_t>& cycles) {
    constexpr std::uint32_t width = 16;
    std::map<std::uint32_t, int> bins;
    for (const std::uint32_t c : cycles) ++bins[c / width * width];
    for (const auto& [from, count] : bins)
        rows.push_back({kind + "_histogram", operands, from, count, {}, ""});
    const auto size = static_cast<int>(cycles.size());
    const auto summary = [&](double value, const char* note) {
        rows.push_back({kind + "_summary", operands, value, size, {}, note});
    };
    summary(*std::min_element(cycles.begin(), cycles.end()), "minimum");
    summary(std::accumulate(cycles.begin(), cycles.end(), 0.0) / size, "mean");
    summary(*std::max_element(cycles.begin(), cycles.end()), "maximum");
}

}  // namespace

std::uint64_t published_quotient(std::int32_t a, std::int32_t b) {
    const auto magnitude = [](std::int32_t x) {
        return static_cast<std::uint64_t>(std::abs(static_cast<std::int64_t>(x)));
    };
    return (magnitude(a) << 16) / magnitude(b);
}

int quotient_bytes(std::int32_t a, std::int32_t b) {
    return (static_cast<int>(std::bit_width(published_quotient(a, b))) + 7) / 8;
}

double DivisionLaw::predict(std::int32_t a, std::int32_t b) const {
    const auto x = terms_of(a, b);
    return constant * x[0] + per_byte * x[1] + per_one * x[2] + negative_a * x[3] +
           negative_b * x[4] + both * x[5] + zero * x[6];
}

DivisionLaw fit_division_law(const std::vector<Division>& divisions) {
    const std::size_t n = divisions.size();
    const auto matrix = [](std::size_t rows, std::size_t columns) {
        return std::unique_ptr<gsl_matrix, void (*)(gsl_matrix*)>(gsl_matrix_alloc(rows, columns),
                                                                  gsl_matrix_free);
    };
    const auto vector = [](std::size_t size) {
        return std::unique_ptr<gsl_vector, void (*)(gsl_vector*)>(gsl_vector_alloc(size),
                                                                  gsl_vector_free);
    };
    const auto x = matrix(n, terms), covariance = matrix(terms, terms);
    const auto y = vector(n), coefficients = vector(terms);
    for (std::size_t i = 0; i < n; ++i) {
        const auto row = terms_of(divisions[i].a, divisions[i].b);
        for (std::size_t j = 0; j < terms; ++j) gsl_matrix_set(x.get(), i, j, row[j]);
        gsl_vector_set(y.get(), i, divisions[i].cycles);
    }
    const std::unique_ptr<gsl_multifit_linear_workspace, void (*)(gsl_multifit_linear_workspace*)>
        workspace(gsl_multifit_linear_alloc(n, terms), gsl_multifit_linear_free);
    double square_sum = 0;
    gsl_multifit_linear(x.get(), y.get(), coefficients.get(), covariance.get(), &square_sum,
                        workspace.get());
    const auto coefficient = [&](std::size_t j) { return gsl_vector_get(coefficients.get(), j); };
    DivisionLaw law{coefficient(0),
                    coefficient(1),
                    coefficient(2),
                    coefficient(3),
                    coefficient(4),
                    coefficient(5),
                    coefficient(6),
                    std::sqrt(square_sum / static_cast<double>(n)),
                    0};
    for (const Division& d : divisions) {
        law.max_residual = std::max(law.max_residual, std::abs(d.cycles - law.predict(d.a, d.b)));
    }
    return law;
}

DivisionStudy study_division(const std::filesystem::path& division_elf, const Operands& published,
                             int samples) {
    simulator::Chip chip{simulator::Elf(division_elf)};
    chip.run_until_function("main");
    simulator::DeviceFunction fixed(chip, "divide_q16_16_published", {4, {4, 4}});
    simulator::DeviceFunction floating(chip, "divide_float_libc", {4, {4, 4}});
    DivisionStudy study;
    Draw draw;
    const auto measure = [&](DivisionCost& cost, std::int32_t a, std::int32_t b, float x, float y) {
        study.divisions.push_back({a, b, fixed(a, b).cycles});
        cost.fixed.push_back(study.divisions.back().cycles);
        cost.floating.push_back(floating(x, y).cycles);
    };
    for (const std::string operands : {"small", "physics", "full"}) {
        DivisionCost cost{operands, {}, {}};
        for (int i = 0; i < samples; ++i) {
            const std::int32_t a = draw(operands), b = draw(operands);
            measure(cost, a, b, static_cast<float>(a) / 65536, static_cast<float>(b) / 65536);
        }
        study.costs.push_back(std::move(cost));
    }
    // The fit must not depend on the one pair that it is to explain.
    study.law = fit_division_law(study.divisions);
    DivisionCost cost{"published", {}, {}};
    const double scale = published.raw ? 1 : 65536;
    const Operands::Pair& pair = published.raw ? published.integer : published.real;
    measure(cost, static_cast<std::int32_t>(pair.a * scale),
            static_cast<std::int32_t>(pair.b * scale), static_cast<float>(published.real.a),
            static_cast<float>(published.real.b));
    study.costs.push_back(std::move(cost));
    return study;
}

std::vector<DivisionRow> division_rows(const DivisionStudy& study, double published_table_ms,
                                       double loop_cycles) {
    std::vector<DivisionRow> rows;
    for (const DivisionCost& cost : study.costs) {
        add_histogram(rows, "fixed_16_16", cost.operands, cost.fixed);
        add_histogram(rows, "float", cost.operands, cost.floating);
    }
    const auto published = [&](double cycles, double value, const char* note) {
        rows.push_back({"published", "", cycles, {}, value, note});
    };
    const double per_pass = published_table_ms / undisturbed_ms(1);
    published(std::round(per_pass), published_table_ms,
              "ms for 30000 in Table 3.2 as cycles, loop included");
    published(std::round(per_pass - loop_cycles), published_table_ms,
              "the same less the loop and its operands' loads");
    published(engine_division_cycles, 62, "us in the running engine as cycles");
    const DivisionLaw& law = study.law;
    const auto coefficient = [&](double value, const char* note) {
        rows.push_back({"law", "", {}, {}, std::round(value * 1000) / 1000 + 0.0, note});
    };
    coefficient(law.constant, "constant");
    coefficient(law.per_byte, "cycles for each byte of the quotient");
    coefficient(law.per_one, "cycles for each one bit of the quotient");
    coefficient(law.negative_a, "cycles where the dividend is negative");
    coefficient(law.negative_b, "cycles where the divisor is negative");
    coefficient(law.both, "cycles more where both are negative");
    coefficient(law.zero, "cycles more where the quotient is zero");
    coefficient(law.rms_residual, "rms residual in cycles");
    coefficient(law.max_residual, "largest residual in cycles");
    return rows;
}

}  // namespace table_3_2
