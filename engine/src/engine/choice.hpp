// SPDX-License-Identifier: MIT
// Choices at compile time: types, and code that is compiled only where a scene uses it.
#pragma once

namespace engine {

template <bool condition, class A, class B>
struct Either {
    using Type = A;
};
template <class A, class B>
struct Either<false, A, B> {
    using Type = B;
};

// Selects an overload: f(If<true>()) calls f(If<true>).
template <bool condition>
struct If {};

// only_if<condition>(subject, [&](auto& subject) { ... }): the lambda is not instantiated where the
// condition is false, so that it may name members that the subject does not have then.
template <bool condition>
struct OnlyIfTrue {
    template <class Subject, class Function>
    static void call(Subject& subject, Function function) {
        function(subject);
    }
};
template <>
struct OnlyIfTrue<false> {
    template <class Subject, class Function>
    static void call(Subject&, Function) {}
};
template <bool condition, class Subject, class Function>
void only_if(Subject& subject, Function function) {
    OnlyIfTrue<condition>::call(subject, function);
}

}  // namespace engine
