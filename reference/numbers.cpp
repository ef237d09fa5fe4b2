// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/numbers.hpp"

namespace reference {

Rational scale(const Rational& x, int exponent) {
    if (exponent >= 0) return x * Rational(Integer(1) << exponent);
    return x / Rational(Integer(1) << -exponent);
}

Real scale(const Real& x, int exponent) { return multiprecision::ldexp(x, exponent); }

Rational floor(const Rational& x) {
    Integer quotient, remainder;
    multiprecision::divide_qr(Integer(numerator(x)), Integer(denominator(x)), quotient, remainder);
    return Rational(remainder < 0 ? Integer(quotient - 1) : quotient);
}

Real floor(const Real& x) { return multiprecision::floor(x); }

int binade(const Rational& x) {
    const Integer magnitude = abs(numerator(x)), divisor = denominator(x);
    const int estimate = int(msb(magnitude)) - int(msb(divisor));  // right, or one too many
    return abs(x) < scale(Rational(1), estimate) ? estimate - 1 : estimate;
}

int binade(const Real& x) { return int(mpfr_get_exp(x.backend().data())) - 1; }

Real to_real(const Rational& x) { return Real(numerator(x)) / Real(denominator(x)); }

}  // namespace reference
