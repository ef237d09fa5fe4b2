// SPDX-License-Identifier: GPL-3.0-or-later
// The host subjects of one format of the library, LIBRARY_FORMAT, from the catalogue's rows. Each
// format has its own translation unit, since it takes ten seconds to compile.
#include <fixedpoint/arithmetic/correctly_rounded.hpp>
#include <fixedpoint/arithmetic/nearest.hpp>
#include <fixedpoint/arithmetic/published.hpp>
#include <fixedpoint/arithmetic/rounded.hpp>
#include <fixedpoint/arithmetic/saturating.hpp>
#include <fixedpoint/arithmetic/small.hpp>
#include <type_traits>

#include "bench/lab/catalogue/functions.hpp"
#include "bench/lab/catalogue/subjects.h"
#include "bench/lab/subjects/host_calls.hpp"

namespace operations {
namespace {

using catalogue::Functions;
using fixedpoint::CorrectlyRounded;
using fixedpoint::Downward;
using fixedpoint::HalfToEven;
using fixedpoint::Nearest;
using fixedpoint::Published;
using fixedpoint::Saturating;
using fixedpoint::Small;
using fixedpoint::TowardZero;
using reference::Operation;

#define OF_FORMAT(format, RawOfFormat, F, ...) \
    using ThisRaw = RawOfFormat;               \
    constexpr int this_fraction = F;
LIBRARY_FORMAT(OF_FORMAT)

template <Operation operation, class Raw, int F, class Policy>
void add(std::vector<HostSubject>& subjects, const char* implementation, bool same_as_default) {
    if constexpr (std::is_same_v<Raw, ThisRaw> && F == this_fraction) {
        constexpr reference::NumberFormat format{reference::FormatKind::fixed, 8 * sizeof(Raw), F,
                                                 !fixedpoint::RawLimits<Raw>::is_signed};
        constexpr auto arithmetic =
            std::is_same_v<Policy, Published>          ? reference::Arithmetic::published
            : std::is_same_v<Policy, Saturating>       ? reference::Arithmetic::saturating
            : std::is_same_v<Policy, CorrectlyRounded> ? reference::Arithmetic::correctly_rounded
            : std::is_same_v<Policy, TowardZero>       ? reference::Arithmetic::toward_zero
            : std::is_same_v<Policy, Downward>         ? reference::Arithmetic::downward
            : std::is_same_v<Policy, HalfToEven>       ? reference::Arithmetic::half_to_even
                                                       : reference::Arithmetic::nearest;
        constexpr reference::Subject subject{operation, format, arithmetic};
        subjects.push_back({subject, implementation, same_as_default,
                            evaluate<operation, Policy, Raw, F>, judge_all<subject>,
                            judge<subject>});
    }
}

#define ADD_OPERATION(name, signature, operands, results, kind, bound_ulp, domain, format, Raw, F, \
                      implementation, Policy, same_as_default)                                     \
    add<Operation::name, Raw, F, Policy>(subjects, #implementation, same_as_default);
#define ADD_FORMAT(format, Raw, F, implementation, Policy, same_as_default, operations) \
    operations(ADD_OPERATION, format, Raw, F, implementation, Policy, same_as_default)

#define ADD_own(implementation, Policy, formats, operations) \
    formats(ADD_FORMAT, implementation, Policy, false, operations)
#define ADD_as_default(implementation, Policy, formats, operations) \
    formats(ADD_FORMAT, implementation, Nearest, true, operations)
#define ADD_none(implementation, Policy, formats, operations)
#define ADD(implementation, Policy, provenance, host, formats, operations, label) \
    ADD_##host(implementation, Policy, formats, operations)

void add_every_implementation(std::vector<HostSubject>& subjects) { IMPLEMENTATIONS(ADD) }

}  // namespace

#define DEFINE_ADDER(format, ...) \
    void add_##format(std::vector<HostSubject>& subjects) { add_every_implementation(subjects); }
LIBRARY_FORMAT(DEFINE_ADDER)

}  // namespace operations
