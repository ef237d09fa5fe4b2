// SPDX-License-Identifier: MIT
// sin, cos and sincos are faithful and never outside [-1, 1].
#include <fixedpoint/kernel/dispatch.hpp>

#include "accuracy.hpp"

namespace {

using namespace fixedpoint;

constexpr exact::Function sine = exact::Function::sin, cosine = exact::Function::cos;

// Checks that sincos agrees with sin and cos; returns a result outside every bound if it does not.
template <class Raw, int F>
int64_t sine_or_cosine(Raw angle, int which) {
    Raw both[2] = {};
    kernel::sincos<Raw, F>(angle, both);
    const bool agree =
        which == 0 ? both[0] == kernel::sin<Raw, F>(angle) : both[1] == kernel::cos<Raw, F>(angle);
    const bool within_one = F == RawLimits<Raw>::width - 1 || (magnitude(both[which]) >> F) == 0 ||
                            magnitude(both[which]) == Unsigned<Raw>(1) << F % RawLimits<Raw>::width;
    return agree && within_one ? int64_t(both[which]) : INT64_MIN / 2 + 12345;
}

// At the peak the sum in the core of the fine splits exceeds the signed range.
static_assert(kernel::cos<int64_t, 31>(0) == int64_t(1) << 31, "");
static_assert(kernel::cos<int64_t, 56>(0) == int64_t(1) << 56, "");

TEST(Sine, IsFaithful) {
    expect_accuracy({"sin", &sine,
                     subjects_of_every_split([]<class Raw, int F>(const int64_t* v) -> int64_t {
                         return sine_or_cosine<Raw, F>(Raw(*v), 0);
                     }),
                     0.75});
}
TEST(Cosine, IsFaithful) {
    expect_accuracy({"cos", &cosine,
                     subjects_of_every_split([]<class Raw, int F>(const int64_t* v) -> int64_t {
                         return sine_or_cosine<Raw, F>(Raw(*v), 1);
                     }),
                     0.75});
}

// Elsewhere it is the same function.
TEST(SmallSine, IsFaithfulInQ16_16) {
    expect_accuracy({"sin_small",
                     &sine,
                     {subject<int32_t, 16>([]<class Raw, int F>(const int64_t* v) -> int64_t {
                         int32_t both[2] = {};
                         portable::sincos_small<Raw, F>(Raw(*v), both);
                         return both[0] == portable::sin_small<Raw, F>(Raw(*v)) ? both[0]
                                                                                : INT32_MIN;
                     })},
                     0.75});
    expect_accuracy({"cos_small",
                     &cosine,
                     {subject<int32_t, 16>([]<class Raw, int F>(const int64_t* v) -> int64_t {
                         int32_t both[2] = {};
                         portable::sincos_small<Raw, F>(Raw(*v), both);
                         return both[1] == portable::cos_small<Raw, F>(Raw(*v)) ? both[1]
                                                                                : INT32_MIN;
                     })},
                     0.75});
}

static_assert(kernel::sin<int32_t, 16>(0) == 0 && kernel::cos<int32_t, 16>(0) == 65536, "exact");
static_assert(kernel::cos<int16_t, 15>(0) == 32767, "saturated");
static_assert(kernel::sin<int32_t, 16>(65536) == 55147, "sin(1) = 0.84147");
static_assert(kernel::cos<int64_t, 60>(int64_t(1) << 60) == 622926147424044489, "cos(1) = 0.54030");

}  // namespace
