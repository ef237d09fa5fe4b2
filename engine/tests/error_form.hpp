// SPDX-License-Identifier: MIT
// Fixed<I, F, Tracked<...>>: a number that represents all numbers that the code could have in its
// place. The code under proof is instantiated with it, so that its own constants, shifts and
// roundings are bounded.
//
// A number is an ideal, which exact arithmetic would have, and an error in ulp. An ideal is a
// polynomial in q, with powers of the distance D of two ends, of the length L of their link and of
// l = sqrt(1 + q), the length of a vector near 1. A vector's ideal is such a number times the unit
// vector n from end to end. n itself remains a symbol: only n . n = 1 is needed. An error is a
// linear form in the roundings, with a remainder of second order. For a vector's rounding h, a box
// with a side for each component, the form contains across h + along n (n . h) in a vector and
// along (n . h) in a scalar, so that what a step corrects cancels.
// Where a comparison cannot be decided, both branches are taken.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <engine/scalar.hpp>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace proof {

struct Unproven : std::runtime_error {
    using std::runtime_error::runtime_error;
};
// The path belongs to another part of the proof.
struct Elsewhere {};

// lo..hi. An end moves outward only if an operation has rounded it, so that dyadic numbers of few
// bits stay exact.
struct Interval {
    double lo, hi;
    constexpr Interval(double x = 0) : lo(x), hi(x) {}
    constexpr Interval(double a, double b) : lo(a), hi(b) {}
    double magnitude() const { return std::max(std::abs(lo), std::abs(hi)); }
};
inline double below(double x, double rest) { return rest < 0 ? std::nextafter(x, -INFINITY) : x; }
inline double above(double x, double rest) { return rest > 0 ? std::nextafter(x, INFINITY) : x; }
inline double sum_rest(double a, double b) {
    const double sum = a + b, part = sum - a;
    return (a - (sum - part)) + (b - part);
}
inline Interval operator+(Interval a, Interval b) {
    return {below(a.lo + b.lo, sum_rest(a.lo, b.lo)), above(a.hi + b.hi, sum_rest(a.hi, b.hi))};
}
inline Interval operator-(Interval a) { return {-a.hi, -a.lo}; }
inline Interval operator-(Interval a, Interval b) { return a + -b; }
inline Interval operator*(Interval a, Interval b) {
    Interval product(INFINITY, -INFINITY);
    for (double x : {a.lo, a.hi}) {
        for (double y : {b.lo, b.hi}) {
            const double p = x * y, rest = std::fma(x, y, -p);
            product = {std::min(product.lo, below(p, rest)), std::max(product.hi, above(p, rest))};
        }
    }
    return product;
}
inline Interval operator/(Interval a, Interval b) {
    if (!(b.lo > 0)) throw Unproven("a divisor may be 0");
    Interval quotient(INFINITY, -INFINITY);
    for (double x : {a.lo, a.hi}) {
        for (double y : {b.lo, b.hi}) {
            const double q = x / y, rest = std::fma(-q, y, x);
            quotient = {std::min(quotient.lo, below(q, rest)),
                        std::max(quotient.hi, above(q, rest))};
        }
    }
    return quotient;
}
inline Interval root(Interval a) {
    if (a.lo < 0) throw Unproven("a root of what may be negative");
    const double low = std::sqrt(a.lo), high = std::sqrt(a.hi);
    return {below(low, std::fma(-low, low, a.lo)), above(high, std::fma(-high, high, a.hi))};
}
inline Interval around(double x) { return {-x, x}; }
inline Interval& operator+=(Interval& a, Interval b) { return a = a + b; }

// Coefficients of 1, q, q^2 ...
using Polynomial = std::vector<Interval>;
inline Polynomial operator+(Polynomial a, const Polynomial& b) {
    if (a.size() < b.size()) a.resize(b.size());
    for (std::size_t i = 0; i < b.size(); ++i) a[i] += b[i];
    return a;
}
inline Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    Polynomial product(a.size() + b.size() - 1);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) product[i + j] += a[i] * b[j];
    return product;
}
// Over all q of an interval; a polynomial divisible by a power of q stays correspondingly small
// near 0.
inline Interval range(const Polynomial& p, Interval q) {
    Interval sum;
    for (std::size_t i = p.size(); i-- > 0;) sum = sum * q + p[i];
    return sum;
}

// Powers of D, L and l = sqrt(1 + q).
using Powers = std::array<int, 3>;
using Ideal = std::map<Powers, Polynomial>;
using Name = std::uint64_t;

// A few values by name.
template <class Value>
struct Named : std::vector<std::pair<Name, Value>> {
    Value& operator[](Name name) {
        for (auto& [known, value] : *this)
            if (known == name) return value;
        return this->emplace_back(name, Value()).second;
    }
    const Value& at(Name name) const {
        for (const auto& [known, value] : *this)
            if (known == name) return value;
        throw Unproven("a rounding without a bound");
    }
};

struct Error {
    Named<Interval> across, along;  // of a box
    Named<Interval> single;         // of a scalar's rounding; in a vector times n
    double rest = 0;                // at most that, or a vector of that length
};

// What is known on one path through the code.
struct Path {
    int integer_bits = 0, fraction_bits = 0, dimensions = 0;
    bool sums_round_once = true;
    Interval q, distance, length;
    Named<Interval> single;     // the range of a rounding, ulp
    Named<double> box;          // the range of a component, either way, ulp
    std::map<Name, int> unit;   // vectors of the ideal l n, and their version
    int version = 0;            // how often q was redefined
    std::vector<bool> answers;  // to questions that could not be decided
    std::size_t asked = 0;
    std::map<std::array<Name, 3>, bool> decided;

    double ulp() const { return std::ldexp(1.0, -fraction_bits); }
    Interval of(const Ideal& ideal) const {
        Interval sum;
        for (const auto& [powers, polynomial] : ideal) {
            Interval term = range(polynomial, q);
            const Interval bases[] = {distance, length, root(Interval(1) + q)};
            for (int i = 0; i < 3; ++i) {
                for (int k = 0; k < powers[i]; ++k) term = term * bases[i];
                for (int k = 0; k > powers[i]; --k) term = term / bases[i];
            }
            sum += term;
        }
        return sum;
    }
    double root_of_dimensions() const { return root(Interval(dimensions)).hi; }
    // A scalar's error, ulp.
    Interval of(const Error& error) const {
        Interval sum = around(error.rest);
        for (const auto& [name, factor] : error.single) sum += factor * single.at(name);
        for (const auto& [name, factor] : error.along)
            sum += factor * around(box.at(name)) * around(root_of_dimensions());
        return sum;
    }
    // The length of a vector's error, ulp.
    double length_of(const Error& error) const {
        Interval sum = error.rest;
        for (const auto& [name, factor] : error.single)
            sum += Interval(factor.magnitude()) * single.at(name).magnitude();
        for (const auto& [name, across] : error.across) {
            const Interval both = across + error.along.at(name);
            sum += Interval(std::max(across.magnitude(), both.magnitude())) * box.at(name) *
                   root_of_dimensions();
        }
        return sum.hi;
    }
    // Whether a < b, and so on. The same question has the same answer.
    bool decide(bool surely, bool surely_not, std::array<Name, 3> question) {
        if (surely || surely_not) return surely;
        if (const auto found = decided.find(question); found != decided.end()) return found->second;
        if (asked == answers.size()) answers.push_back(false);
        return decided[question] = answers[asked++];
    }
};
inline Path path;

// Runs it on every path that starts like this one.
template <class Run>
void on_all_paths(const Path& start, Run run) {
    for (std::vector<bool> answers;;) {
        path = start;
        path.answers = answers;
        try {
            run();
        } catch (const Elsewhere&) {
        }
        answers = path.answers;
        answers.resize(std::min(answers.size(), path.asked));
        while (!answers.empty() && answers.back()) answers.pop_back();
        if (answers.empty()) return;
        answers.back() = true;
    }
}

inline Name name_of(std::initializer_list<Name> parts) {
    Name name = 14695981039346656037u;
    for (Name part : parts) {
        for (int i = 0; i < 8; ++i) name = (name ^ (part >> 8 * i & 255)) * 1099511628211u;
    }
    return name;
}

// Of the input 1 / length, whose error is symmetric about 0.
constexpr Name factor_name = 2;

// A scalar, or the whole vector in place of a component.
struct Number {
    Name name = 0;
    bool vector = false;
    int version = 0;  // of the q that the ideal refers to
    Ideal ideal;
    Error error;

    static Number constant(double value) {
        Number number;
        number.name = name_of({1, static_cast<Name>(std::llround(std::ldexp(value, 32)))});
        if (value != 0) number.ideal[{0, 0, 0}] = {value};
        return number;
    }
    static Number symbol(Name name, bool vector, Powers powers, Interval factor = 1) {
        Number number;
        number.name = name_of({2, name});
        number.vector = vector;
        number.ideal[powers] = {factor};
        return number;
    }
    // In terms of the present q.
    Number current() const {
        Number number = *this;
        if (const auto found = path.unit.find(name); found != path.unit.end()) {
            number.ideal = {{{0, 0, 1}, {1}}};
            number.version = found->second;
        }
        for (const auto& [powers, polynomial] : number.ideal) {
            const bool depends = powers[2] != 0 || polynomial.size() > 1;
            if (depends && number.version != path.version)
                throw Unproven("a number of an earlier step is used");
        }
        number.version = path.version;
        return number;
    }
};

inline void take_squares_of_l(Ideal& ideal) {
    Ideal made;
    for (const auto& term : ideal) {
        Powers powers = term.first;
        Polynomial polynomial = term.second;
        for (; powers[2] > 1; powers[2] -= 2) polynomial = polynomial * Polynomial{1, 1};
        made[powers] = made.contains(powers) ? made[powers] + polynomial : polynomial;
    }
    ideal = made;
}
inline Ideal operator*(const Ideal& a, const Ideal& b) {
    Ideal product;
    for (const auto& [p, x] : a) {
        for (const auto& [r, y] : b) {
            const Powers powers = {p[0] + r[0], p[1] + r[1], p[2] + r[2]};
            product[powers] = product[powers].empty() ? x * y : product[powers] + x * y;
        }
    }
    take_squares_of_l(product);
    return product;
}
inline void add_scaled(Named<Interval>& sum, const Named<Interval>& terms, Interval factor) {
    for (const auto& [name, coefficient] : terms) sum[name] += coefficient * factor;
}
inline void add_scaled(Error& sum, const Error& error, Interval factor) {
    add_scaled(sum.across, error.across, factor);
    add_scaled(sum.along, error.along, factor);
    add_scaled(sum.single, error.single, factor);
    sum.rest = (Interval(sum.rest) + Interval(factor.magnitude()) * error.rest).hi;
}

// The result, within the range, plus its rounding.
inline Number rounded(Number number, Interval rounding) {
    if (rounding.magnitude() != 0) {
        if (number.vector) {
            number.error.across[number.name] = 1;
            number.error.along[number.name] += 0;
            path.box[number.name] = rounding.magnitude();
        } else {
            number.error.single[number.name] = 1;
            path.single[number.name] = rounding;
        }
    }
    const Interval error =
        number.vector ? around(path.length_of(number.error)) : path.of(number.error);
    const Interval value = path.of(number.ideal) + error * path.ulp();
    if (value.magnitude() >= std::ldexp(1.0, path.integer_bits - 1))
        throw Unproven("a number may leave the format");
    return number;
}
inline Number sum(const Number& x, const Number& y, int sign) {
    const Number a = x.current(), b = y.current();
    const auto is_zero = [](const Number& n) {
        return n.ideal.empty() && n.error.single.empty() && n.error.across.empty() &&
               n.error.rest == 0;
    };
    if (is_zero(b)) return a;
    if (a.vector != b.vector && !is_zero(a)) throw Unproven("a scalar is added to a vector");
    Number result = a;
    result.vector = b.vector;
    result.name = name_of({3, a.name, b.name, static_cast<Name>(sign)});
    for (auto [powers, polynomial] : b.ideal) {
        for (Interval& coefficient : polynomial) coefficient = coefficient * sign;
        result.ideal[powers] = result.ideal[powers] + polynomial;
    }
    add_scaled(result.error, b.error, sign);
    return rounded(result, 0);
}
inline Number product(const Number& x, const Number& y, Interval rounding = {-0.5, 0.5}) {
    const Number a = (y.vector ? y : x).current(), b = (y.vector ? x : y).current();
    if (b.vector) throw Unproven("components are multiplied");
    Number result;
    result.vector = a.vector;
    result.version = path.version;
    result.name = name_of({4, a.name, b.name});
    result.ideal = a.ideal * b.ideal;
    add_scaled(result.error, a.error, path.of(b.ideal));
    // Of a vector the other factor's error counts along n.
    for (const auto& [name, along] : b.error.along) result.error.across[name] += 0;
    if (!a.vector) result.error.across.clear();
    const Interval factor = path.of(a.ideal);
    if (b.error.single.size() == 1 && b.error.single.front().first == name_of({2, factor_name})) {
        // 1 / length is not used elsewhere. It counts as a separate rounding immediately: steps
        // cancel a number better than a range.
        const Name own = name_of({8, result.name});
        path.single[own] = b.error.single.front().second * path.single.at(b.name);
        result.error.single[own] = factor.magnitude();
    } else {
        add_scaled(result.error, b.error, factor);
    }
    const double size = a.vector ? path.length_of(a.error) : path.of(a.error).magnitude();
    result.error.rest =
        (Interval(result.error.rest) + Interval(size) * path.of(b.error).magnitude() * path.ulp())
            .hi;
    return rounded(result, rounding);
}
inline Number shifted(const Number& x, int count) {
    Number result = x.current();
    const double factor = std::ldexp(1.0, -count);
    result.name = name_of({5, x.name, static_cast<Name>(count)});
    for (auto& [powers, polynomial] : result.ideal)
        for (Interval& coefficient : polynomial) coefficient = coefficient * factor;
    result.error = {};
    add_scaled(result.error, x.current().error, factor);
    return rounded(result, {factor - 1, 0});
}
// Defines l as the vector's length from now on, if it is the vector's own.
inline void choose_q(const Number& v, Interval square) {
    ++path.version;
    path.q = square - 1;
    path.unit[v.name] = path.version;
}
inline Number dot(const Number& x, const Number& y) {
    if (x.name == y.name) {
        Ideal square = x.current().ideal * x.current().ideal;
        const bool first = square.begin()->first == Powers{2, -2, 0};  // 1 + q, as given
        if (square.size() != 1) throw Unproven("a length that is not followed");
        choose_q(x, first ? path.q + 1 : path.of(square));
    }
    const Number a = x.current(), b = y.current();
    if (!a.vector || !b.vector) throw Unproven("a dot product of scalars");
    Number result;
    result.version = path.version;
    result.name = name_of({6, a.name, b.name});
    result.ideal = a.ideal * b.ideal;
    for (const auto& [u, v] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
        const Interval factor = path.of(u->ideal);
        for (const auto& [name, along] : v->error.along)
            result.error.along[name] += (v->error.across.at(name) + along) * factor;
        add_scaled(result.error.single, v->error.single, factor);
        result.error.rest =
            (Interval(result.error.rest) + Interval(factor.magnitude()) * v->error.rest).hi;
    }
    const Interval second = Interval(path.length_of(a.error)) * path.length_of(b.error);
    result.error.rest = (Interval(result.error.rest) + second * path.ulp()).hi;
    return rounded(result, around(path.sums_round_once ? 0.5 : 0.5 * path.dimensions));
}
inline Interval value(const Number& x) {
    const Number number = x.current();
    if (number.vector) throw Unproven("a vector's component is compared");
    return path.of(number.ideal) + path.of(number.error) * path.ulp();
}

// The arithmetic: sums of products are rounded once, or each product separately.
struct Tracked {
    template <class Raw, int F>
    static Raw dot2(const Raw*, const Raw*);
};

}  // namespace proof

namespace fixedpoint {

template <int I, int F>
class Fixed<I, F, proof::Tracked> : public proof::Number {
  public:
    using Raw = Integer<I + F>;
    Fixed() : Number(Number::constant(0)) {}
    explicit Fixed(const Number& number) : Number(number) {}
    static Fixed from_raw(Raw raw) { return Fixed(constant(std::ldexp(double(raw), -F))); }

    friend Fixed operator+(const Fixed& a, const Fixed& b) { return Fixed(sum(a, b, 1)); }
    friend Fixed operator-(const Fixed& a, const Fixed& b) { return Fixed(sum(a, b, -1)); }
    friend Fixed operator*(const Fixed& a, const Fixed& b) { return Fixed(product(a, b)); }
    friend Fixed operator>>(const Fixed& a, int count) { return Fixed(proof::shifted(a, count)); }
    Fixed operator-() const { return Fixed() - *this; }
    Fixed& operator+=(const Fixed& b) { return *this = *this + b; }
    Fixed& operator-=(const Fixed& b) { return *this = *this - b; }
    Fixed& operator*=(const Fixed& b) { return *this = *this * b; }
    friend bool operator<(const Fixed& a, const Fixed& b) {
        const proof::Interval x = value(a), y = value(b);
        return proof::path.decide(x.hi < y.lo, x.lo >= y.hi, {0, a.name, b.name});
    }
    friend bool operator>(const Fixed& a, const Fixed& b) { return b < a; }
    friend bool operator==(const Fixed& a, const Fixed& b) {
        const proof::Interval x = value(a), y = value(b);
        return proof::path.decide(x.lo == x.hi && x.lo == y.lo && x.hi == y.hi,
                                  x.hi < y.lo || x.lo > y.hi, {1, a.name, b.name});
    }
};

}  // namespace fixedpoint

namespace proof {

template <int I, int F>
using Scalar = fixedpoint::Fixed<I, F, Tracked>;

// Every component stands for the whole vector: all must result from the same operations.
template <int N, int I, int F>
const Number& whole(const Scalar<I, F>* v) {
    for (int i = 1; i < N; ++i)
        if (v[i].name != v[0].name) throw Unproven("components are treated unequally");
    return v[0];
}
// The functions that the engine's vectors call.
template <int N, int I, int F>
Scalar<I, F> dot(const Scalar<I, F>* a, const Scalar<I, F>* b) {
    return Scalar<I, F>(dot(whole<N>(a), whole<N>(b)));
}

}  // namespace proof

namespace engine {

template <int I, int F>
struct MultiplyAdd<proof::Scalar<I, F>> {
    using Number = proof::Scalar<I, F>;
    static Number of(const Number& a, const Number& b, const Number& c) { return a * b + c; }
};

}  // namespace engine
