// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/world_of.hpp"

namespace stability {
namespace {

template <int I, int F>
Subject in_format(const char* scalar) {
    using Scalar = fixedpoint::Fixed<I, F, Recording>;
    return {scalar,
            "nearest",
            ContinuousContacts::name,
            to_double(Scalar::max()),
            to_double(Scalar::ulp()),
            Run<Scalar, ContinuousContacts>::run};
}
template <class Scalar>
Subject floating(const char* scalar) {
    return {scalar,
            "ieee",
            ContinuousContacts::name,
            std::numeric_limits<Scalar>::max(),
            0,
            Run<Scalar, ContinuousContacts>::run};
}

}  // namespace

std::vector<Subject> subjects_of_continuous_contacts() {
    return {in_format<8, 8>("q8_8"), in_format<16, 16>("q16_16"), in_format<32, 32>("q32_32"),
            in_format<8, 24>("q8_24"), floating<float>("float")};
}

std::vector<Subject> subjects_of_continuous_contacts_in_double() {
    return {floating<double>("double")};
}

}  // namespace stability
