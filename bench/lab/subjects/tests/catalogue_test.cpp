// SPDX-License-Identifier: GPL-3.0-or-later
// The two sides of the catalogue against each other: everything measured on the chip has a host
// subject, and vice versa.
#include "bench/lab/catalogue/catalogue.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "bench/chip/simulator/elf.hpp"
#include "bench/lab/subjects/device_subject.hpp"
#include "bench/lab/subjects/host_subject.hpp"
#include "this_build.hpp"

namespace operations {
namespace {

std::set<std::string> on_the_chip() {
    std::set<std::string> names;
    for (const std::string& program : catalogue::programs())
        for (const std::string& name :
             subjects_of(simulator::Elf(build_folder() / "bench/device" / (program + ".elf"))))
            EXPECT_TRUE(names.insert(name).second) << name << " is in two programs";
    return names;
}

std::set<std::string> on_the_host() {
    std::set<std::string> names;
    for (const HostSubject& host : host_subjects())
        if (host.subject.operation != reference::Operation::convert) {
            EXPECT_TRUE(names.insert(host.name()).second) << host.name() << " is there twice";
        }
    return names;
}

TEST(Catalogue, EachSideHasWhatTheOtherHas) {
    const std::set<std::string> host = on_the_host();
    std::map<std::string, int> rivals;
    for (const std::string& name : on_the_chip()) {
        const reference::NamedSubject named = reference::parse_symbol(name);
        if (catalogue::is_held_to_its_definition(named))
            EXPECT_TRUE(host.contains(name)) << name << " has no subject on the host";
        else
            ++rivals[named.implementation];
    }
    const std::set<std::string> chip = on_the_chip();
    for (const std::string& name : host)
        EXPECT_TRUE(chip.contains(name)) << name << " has no subject on the chip";
    EXPECT_EQ(rivals, (std::map<std::string, int>{{"accum", 16}, {"libc", 51}, {"native", 20}}));
}

TEST(Catalogue, KnowsWhichResultsAreHeldToADefinition) {
    const auto held = [](const char* symbol) {
        return catalogue::is_held_to_its_definition(reference::parse_symbol(symbol));
    };
    EXPECT_TRUE(held("multiply_q16_16_default"));
    EXPECT_TRUE(held("multiply_q16_16_published"));
    EXPECT_FALSE(held("multiply_float_libc"));
    EXPECT_FALSE(held("multiply_s16_15_accum"));
    EXPECT_TRUE(held("multiply_q16_16_yours"));
    EXPECT_FALSE(held("multiply_int32_yours"));
}

TEST(Catalogue, AHostSubjectComputesWhatItsNameSays) {
    std::map<std::string, const HostSubject*> by_name;
    for (const HostSubject& host : host_subjects()) by_name[host.name()] = &host;
    const auto results = [&](const char* name, std::vector<std::int64_t> operands) {
        const HostSubject& host = *by_name.at(name);
        const std::size_t calls =
            operands.size() / reference::shape(host.subject.operation).operands;
        std::vector<std::int64_t> results(calls * reference::shape(host.subject.operation).results);
        host.evaluate(operands, results);
        return results;
    };
    using Raws = std::vector<std::int64_t>;
    // Two calls, one after the other.
    EXPECT_EQ(results("divide_q8_8_default", {256, 512, -768, 512}), (Raws{128, -384}));
    EXPECT_EQ(results("subtract_q4_4_saturating", {-128, 1, 3, 1}), (Raws{-128, 2}));
    EXPECT_EQ(results("multiply_add_q16_16_default", {131072, 32768, 7}), (Raws{65543}));
    EXPECT_EQ(results("dot3_q8_8_default", {256, 512, 768, 1, 2, 3}), (Raws{14}));
    EXPECT_EQ(results("length2_q16_16_default", {196608, 262144}), (Raws{327680}));
    EXPECT_EQ(results("normalise3_q16_16_default", {0, -65536, 0, 0, 0, 5}),
              (Raws{0, -65536, 0, 0, 0, 65536}));
    EXPECT_EQ(results("sincos_q16_16_small", {0, 0}), (Raws{0, 65536, 0, 65536}));
    EXPECT_EQ(results("convert_q16_16_q8_8_saturating", {0x7fffffff, -65536}), (Raws{32767, -256}));
}

}  // namespace
}  // namespace operations
