// SPDX-License-Identifier: MIT
// BuiltinNumber<T>: classifies the integer and floating-point types of the language without
// <type_traits>, which the chip's compiler does not have. Its member types are the result types of
// deleted functions: their names appear in the first line of the compiler's error and say what to
// write instead.
#pragma once

namespace fixedpoint {

struct Refused;

enum class BuiltinKind : unsigned char {
    none,
    integer,    // a quantity: may be mixed with a fixed-point number
    character,  // and bool: integers to the language, but not quantities
    floating_point
};

template <BuiltinKind builtin_kind>
struct BuiltinNumberOf {
    static constexpr BuiltinKind kind = builtin_kind;
    static constexpr bool is_integer =
        kind == BuiltinKind::integer || kind == BuiltinKind::character;
    using write_a_literal_or_from_integer_or_from_float = Refused;
};

template <class Number>
struct BuiltinNumber {
    static constexpr BuiltinKind kind = BuiltinKind::none;
    static constexpr bool is_integer = false;
};
template <class Number>
struct BuiltinNumber<const Number> : BuiltinNumber<Number> {};
// clang-format off
template <> struct BuiltinNumber<bool> : BuiltinNumberOf<BuiltinKind::character> {};
template <> struct BuiltinNumber<char> : BuiltinNumberOf<BuiltinKind::character> {};
template <> struct BuiltinNumber<signed char> : BuiltinNumberOf<BuiltinKind::integer> {};
template <> struct BuiltinNumber<unsigned char> : BuiltinNumberOf<BuiltinKind::integer> {};
template <> struct BuiltinNumber<short> : BuiltinNumberOf<BuiltinKind::integer> {};
template <> struct BuiltinNumber<unsigned short> : BuiltinNumberOf<BuiltinKind::integer> {};
template <> struct BuiltinNumber<int> : BuiltinNumberOf<BuiltinKind::integer> {};
template <> struct BuiltinNumber<unsigned> : BuiltinNumberOf<BuiltinKind::integer> {};
template <> struct BuiltinNumber<long> : BuiltinNumberOf<BuiltinKind::integer> {};
template <> struct BuiltinNumber<unsigned long> : BuiltinNumberOf<BuiltinKind::integer> {};
template <> struct BuiltinNumber<long long> : BuiltinNumberOf<BuiltinKind::integer> {};
template <> struct BuiltinNumber<unsigned long long> : BuiltinNumberOf<BuiltinKind::integer> {};
template <> struct BuiltinNumber<wchar_t> : BuiltinNumberOf<BuiltinKind::character> {};
template <> struct BuiltinNumber<char16_t> : BuiltinNumberOf<BuiltinKind::character> {};
template <> struct BuiltinNumber<char32_t> : BuiltinNumberOf<BuiltinKind::character> {};
#ifdef __cpp_char8_t
template <> struct BuiltinNumber<char8_t> : BuiltinNumberOf<BuiltinKind::character> {};
#endif
#ifdef __SIZEOF_INT128__
__extension__ template <> struct BuiltinNumber<__int128> : BuiltinNumberOf<BuiltinKind::character> {};
__extension__ template <> struct BuiltinNumber<unsigned __int128> : BuiltinNumberOf<BuiltinKind::character> {};
#endif
template <> struct BuiltinNumber<float> : BuiltinNumberOf<BuiltinKind::floating_point> {};
template <> struct BuiltinNumber<double> : BuiltinNumberOf<BuiltinKind::floating_point> {};
template <> struct BuiltinNumber<long double> : BuiltinNumberOf<BuiltinKind::floating_point> {};
// clang-format on

// Result if Number is an integer that may be mixed with a fixed-point number; otherwise there is no
// Type, which removes the operator from overload resolution.
template <class Number, class Result, BuiltinKind = BuiltinNumber<Number>::kind>
struct BesideInteger {};
template <class Number, class Result>
struct BesideInteger<Number, Result, BuiltinKind::integer> {
    using Type = Result;
};

// The built-in numbers that may not be mixed with a fixed-point number.
template <class Number, BuiltinKind = BuiltinNumber<Number>::kind>
struct NotBesideFixed : BuiltinNumber<Number> {};
template <class Number>
struct NotBesideFixed<Number, BuiltinKind::integer> {};

}  // namespace fixedpoint
