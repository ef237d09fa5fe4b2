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
#define IN_FORMAT(format, I, F) in_format<I, F>(#format),
    return {STABILITY_FORMATS(IN_FORMAT) floating<float>("float")};
#undef IN_FORMAT
}

std::vector<Subject> subjects_of_continuous_contacts_in_double() {
    return {floating<double>("double")};
}

}  // namespace stability
