// SPDX-License-Identifier: MIT
// BuiltinNumber<T>: says of the integers and floating-point types of the language that they are
// such, without <type_traits>, which the chip's compiler does not have. Its member types are the
// results of deleted functions: their names stand in the compiler's first line and say what to
// write instead.
#pragma once

namespace fixedpoint {

struct Refused;

template <bool is_integer_type>
struct BuiltinNumberOf {
    static constexpr bool is_integer = is_integer_type;
    using write_a_literal_or_from_integer_or_from_float = Refused;
};

template <class Number>
struct BuiltinNumber {
    static constexpr bool is_integer = false;
};
template <class Number>
struct BuiltinNumber<const Number> : BuiltinNumber<Number> {};
// clang-format off
template <> struct BuiltinNumber<bool> : BuiltinNumberOf<true> {};
template <> struct BuiltinNumber<char> : BuiltinNumberOf<true> {};
template <> struct BuiltinNumber<signed char> : BuiltinNumberOf<true> {};
template <> struct BuiltinNumber<unsigned char> : BuiltinNumberOf<true> {};
template <> struct BuiltinNumber<short> : BuiltinNumberOf<true> {};
template <> struct BuiltinNumber<unsigned short> : BuiltinNumberOf<true> {};
template <> struct BuiltinNumber<int> : BuiltinNumberOf<true> {};
template <> struct BuiltinNumber<unsigned> : BuiltinNumberOf<true> {};
template <> struct BuiltinNumber<long> : BuiltinNumberOf<true> {};
template <> struct BuiltinNumber<unsigned long> : BuiltinNumberOf<true> {};
template <> struct BuiltinNumber<long long> : BuiltinNumberOf<true> {};
template <> struct BuiltinNumber<unsigned long long> : BuiltinNumberOf<true> {};
template <> struct BuiltinNumber<wchar_t> : BuiltinNumberOf<true> {};
template <> struct BuiltinNumber<char16_t> : BuiltinNumberOf<true> {};
template <> struct BuiltinNumber<char32_t> : BuiltinNumberOf<true> {};
#ifdef __cpp_char8_t
template <> struct BuiltinNumber<char8_t> : BuiltinNumberOf<true> {};
#endif
#ifdef __SIZEOF_INT128__
__extension__ template <> struct BuiltinNumber<__int128> : BuiltinNumberOf<true> {};
__extension__ template <> struct BuiltinNumber<unsigned __int128> : BuiltinNumberOf<true> {};
#endif
template <> struct BuiltinNumber<float> : BuiltinNumberOf<false> {};
template <> struct BuiltinNumber<double> : BuiltinNumberOf<false> {};
template <> struct BuiltinNumber<long double> : BuiltinNumberOf<false> {};
// clang-format on

}  // namespace fixedpoint
