// SPDX-License-Identifier: MIT
// atan, atan2 and the reciprocal square roots from tables are faithful and saturated.
#include <fixedpoint/kernel/dispatch.hpp>

#include "accuracy.hpp"

namespace {

using namespace fixedpoint;

constexpr exact::Function arctangent = exact::Function::atan;
constexpr exact::Function reciprocal_root = exact::Function::reciprocal_sqrt;

TEST(Atan2, IsFaithful) {
    expect_accuracy({"atan2", nullptr,
                     subjects_of_every_split([]<class Raw, int F>(const int64_t* v) -> int64_t {
                         return kernel::atan2<Raw, F>(Raw(v[0]), Raw(v[1]));
                     }),
                     0.75});
}
// Formats with few fraction bits round an angle of Q8.8, of which one in 16 is a tie.
TEST(Atan2, OfMirroredVectorsIsMirrored) {
    for (int y = 1; y < 128; ++y)
        for (int x = -128; x < 128; ++x) {
            ASSERT_EQ((kernel::atan2<int8_t, 4>(int8_t(-y), int8_t(x))),
                      (-kernel::atan2<int8_t, 4>(int8_t(y), int8_t(x))))
                << y << ' ' << x;
            ASSERT_EQ((kernel::atan2<int16_t, 3>(int16_t(-y), int16_t(x))),
                      (-kernel::atan2<int16_t, 3>(int16_t(y), int16_t(x))))
                << y << ' ' << x;
        }
}
TEST(Atan, IsFaithful) {
    expect_accuracy({"atan", &arctangent,
                     subjects_of_every_split([]<class Raw, int F>(const int64_t* v) -> int64_t {
                         return kernel::atan<Raw, F>(Raw(*v));
                     }),
                     0.75});
}

// Formats of 32 and 64 bits other than Q16.16 do not have another implementation.
template <class Wrap>
std::vector<Subject> narrow_and_q16_16(Wrap wrap) {
    std::vector<Subject> all;
    add_subjects<int8_t>(all, wrap, std::make_integer_sequence<int, 8>());
    add_subjects<int16_t>(all, wrap, std::integer_sequence<int, 0, 3, 8, 13, 14, 15>());
    add_subjects<int32_t>(all, wrap, std::integer_sequence<int, 16>());
    return all;
}
TEST(SmallAtan2, IsFaithful) {
    expect_accuracy({"atan2_small", nullptr,
                     narrow_and_q16_16([]<class Raw, int F>(const int64_t* v) -> int64_t {
                         return portable::atan2_small<Raw, F>(Raw(v[0]), Raw(v[1]));
                     }),
                     0.75});
}
TEST(SmallAtan, IsFaithful) {
    expect_accuracy({"atan_small", &arctangent,
                     narrow_and_q16_16([]<class Raw, int F>(const int64_t* v) -> int64_t {
                         return portable::atan_small<Raw, F>(Raw(*v));
                     }),
                     0.75});
}

TEST(SmallReciprocalSqrt, IsFaithfulInQ16_16) {
    expect_accuracy({"reciprocal_sqrt_small",
                     &reciprocal_root,
                     {subject<int32_t, 16>([]<class Raw, int F>(const int64_t* v) -> int64_t {
                         return portable::reciprocal_sqrt_small<Raw, F>(Raw(*v));
                     })},
                     0.75});
}

TEST(ReciprocalSqrt, IsFaithful) {
    std::vector<Subject> all;
    const auto wrap = []<class Raw, int F>(const int64_t* v) -> int64_t {
        return kernel::reciprocal_sqrt<Raw, F>(Raw(*v));
    };
    add_subjects<int8_t>(all, wrap, std::make_integer_sequence<int, 8>());
    add_subjects<int16_t>(all, wrap, std::integer_sequence<int, 0, 3, 8, 13, 14, 15>());
    add_subjects<int32_t>(all, wrap, std::integer_sequence<int, 0, 8, 16, 24, 31>());
    add_subjects<int64_t>(all, wrap,
                          std::integer_sequence<int, 0, 15, 16, 31, 32, 40, 47, 56, 60, 63>());
    expect_accuracy({"reciprocal_sqrt", &reciprocal_root, all, 0.75});
}
TEST(ReciprocalSqrt, IsFaithfulForAMillionInputsOfQ16_16) {
    for (int32_t a = 1; a < 1 << 20; ++a) {
        const int32_t result = portable::reciprocal_sqrt<int32_t, 16>(a);
        ASSERT_LE(std::fabs(result - 16777216.0L / std::sqrt((long double)a)), 0.6441L) << a;
    }
}

static_assert(kernel::atan2<int32_t, 16>(0, 0) == 0 && kernel::atan2<int32_t, 16>(0, 1) == 0, "");
static_assert(kernel::atan2<int32_t, 16>(0, -1) == 205887, "pi");
static_assert(kernel::atan2<int32_t, 16>(1, 0) == 102944, "half pi");
static_assert(kernel::atan2<int32_t, 16>(-1, 0) == -102944, "half pi below");
static_assert(kernel::atan2<int16_t, 15>(0, -1) == 32767, "saturated");
static_assert(kernel::atan2<int32_t, 16>(65536, 65536) == 51472, "a quarter of pi");
static_assert(kernel::atan<int64_t, 60>(int64_t(1) << 60) == 905502432259640355, "atan(1)");
static_assert(kernel::reciprocal_sqrt<int32_t, 16>(0) == INT32_MAX, "");
static_assert(kernel::reciprocal_sqrt<int32_t, 16>(-1) == 0, "");
static_assert(kernel::reciprocal_sqrt<int32_t, 16>(INT32_MIN) == 0, "");
static_assert(kernel::reciprocal_sqrt<int32_t, 16>(65536) == 65536, "1 / sqrt(1)");

}  // namespace
