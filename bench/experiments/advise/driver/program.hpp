// SPDX-License-Identifier: GPL-3.0-or-later
// The user's file, PROGRAM, which defines `template <class Number> class Program` with a member
// function `Number step(Number...)`. It is included after what the engine needs for a Recorded
// double.
#pragma once

#include <engine/decimal.hpp>
#include <engine/scalar.hpp>

#ifndef __AVR__
#include <fixedpoint/host/recorded.hpp>

namespace fixedpoint {

// The engine requires these functions of its scalar. The library's own round once and have no
// intermediate overflow.
template <int N, class Value>
Recorded<Value> dot(const Recorded<Value>* a, const Recorded<Value>* b,
                    const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
    Value sum = a[0].value() * b[0].value();
    for (int i = 1; i < N; ++i) sum += a[i].value() * b[i].value();
    return Recorded<Value>::of(N == 2 ? "dot2" : "dot3", sum, sum, file, line);
}
template <int N, class Value>
Recorded<Value> length(const Recorded<Value>* v, const char* file = __builtin_FILE(),
                       int line = __builtin_LINE()) {
    Value sum = v[0].value() * v[0].value();
    for (int i = 1; i < N; ++i) sum += v[i].value() * v[i].value();
    const Value root = std::sqrt(sum);
    return Recorded<Value>::of(N == 2 ? "length2" : "length3", root, root, file, line);
}

}  // namespace fixedpoint

namespace engine {

template <class Value>
struct MultiplyAdd<fixedpoint::Recorded<Value>> {
    using Number = fixedpoint::Recorded<Value>;
    static Number of(Number a, Number b, Number c) {
        const Value sum = a.value() * b.value() + c.value();
        return Number::of("multiply_add", sum, sum);
    }
};
// A constant that does not fit a format does not compile in it.
template <class Value, int64_t digits, unsigned char places>
struct DecimalIn<fixedpoint::Recorded<Value>, digits, places> {
    static fixedpoint::Recorded<Value> value() {
        const Value constant = DecimalIn<Value, digits, places>::value();
        fixedpoint::recording().variables["constants"].add(constant);
        return fixedpoint::Recorded<Value>(constant);
    }
};

}  // namespace engine
#endif

#include PROGRAM
