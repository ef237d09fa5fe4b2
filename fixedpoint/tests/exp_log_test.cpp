// SPDX-License-Identifier: MIT
// exp and log are faithful and saturated.
#include <cmath>
#include <fixedpoint/kernel/dispatch.hpp>

#include "accuracy.hpp"

namespace {

using namespace fixedpoint;

constexpr exact::Function exponential = exact::Function::exp, logarithm = exact::Function::log;

TEST(Exponential, IsFaithful) {
    expect_accuracy({"exp", &exponential,
                     subjects_of_every_split([]<class Raw, int F>(const int64_t* v) -> int64_t {
                         return kernel::exp<Raw, F>(Raw(*v));
                     }),
                     0.75});
}
TEST(Logarithm, IsFaithful) {
    expect_accuracy({"log", &logarithm,
                     subjects_of_every_split([]<class Raw, int F>(const int64_t* v) -> int64_t {
                         return kernel::log<Raw, F>(Raw(*v));
                     }),
                     0.76});
}

// Formats of 32 and 64 bits other than Q16.16 do not have another implementation.
template <class Wrap>
std::vector<Subject> narrow_and_q16_16(Wrap wrap) {
    std::vector<Subject> all;
    add_subjects<int8_t>(all, wrap, std::make_integer_sequence<int, 8>());
    add_subjects<int16_t>(all, wrap, std::make_integer_sequence<int, 16>());
    add_subjects<int32_t>(all, wrap, std::integer_sequence<int, 16>());
    return all;
}
TEST(SmallExponential, IsFaithful) {
    expect_accuracy({"exp_small", &exponential,
                     narrow_and_q16_16([]<class Raw, int F>(const int64_t* v) -> int64_t {
                         return portable::exp_small<Raw, F>(Raw(*v));
                     }),
                     0.75});
}
TEST(SmallLogarithm, IsFaithful) {
    expect_accuracy({"log_small", &logarithm,
                     narrow_and_q16_16([]<class Raw, int F>(const int64_t* v) -> int64_t {
                         return portable::log_small<Raw, F>(Raw(*v));
                     }),
                     0.76});
}

// Every path of the kernel, one of which is taken by only one operand in 100,000. Beyond +-12 the
// result is 0 or the largest number, which the boundaries cover.
TEST(Exponential, IsFaithfulForEveryInputOfQ16_16ThatIsNotSaturated) {
    long double largest = 0;
    for (int32_t a = -12 * 65536; a < 12 * 65536; ++a) {
        const long double exact =
            std::fmin(std::ldexp(std::exp(a / 65536.0L), 16), (long double)INT32_MAX);
        const long double error = std::fabs(kernel::exp<int32_t, 16>(a) - exact);
        ASSERT_LE(error, 0.75) << a;
        largest = std::fmax(largest, error);
    }
    EXPECT_NEAR(double(largest), 0.654391, 1e-6);
}

// ln 32768 = 681391.4 / 65536, -17 ln 2 = -772243.6 / 65536
static_assert(kernel::exp<int32_t, 16>(0) == 65536 && kernel::exp<int8_t, 7>(0) == 127, "");
static_assert(kernel::exp<int32_t, 16>(681391) < INT32_MAX, "");
static_assert(kernel::exp<int32_t, 16>(681392) == INT32_MAX, "");
static_assert(kernel::exp<int32_t, 16>(-772243) == 1 && kernel::exp<int32_t, 16>(-772244) == 0, "");
static_assert(kernel::exp<int32_t, 16>(INT32_MAX) == INT32_MAX, "");
static_assert(kernel::exp<int32_t, 16>(INT32_MIN) == 0, "");
static_assert(kernel::exp<int32_t, 16>(65536) == 178145, "e = 2.71828");
static_assert(kernel::exp<int64_t, 60>(int64_t(1) << 60) == 3133965575612453543, "e = 2.71828");
static_assert(kernel::log<int32_t, 16>(65536) == 0 && kernel::log<int8_t, 7>(1) == -128, "");
static_assert(kernel::log<int32_t, 16>(0) == INT32_MIN && kernel::log<int32_t, 16>(-1) == INT32_MIN,
              "");
static_assert(kernel::log<int64_t, 62>(1) == INT64_MIN, "");
static_assert(kernel::log<int32_t, 16>(131072) == 45426, "ln 2 = 0.69315");
static_assert(kernel::log<int64_t, 60>(int64_t(1) << 61) == 799144290325165979, "ln 2 = 0.69315");

}  // namespace
