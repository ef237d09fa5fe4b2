// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/cost/features/linked.hpp"

#include <cxxabi.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <regex>

#include "bench/chip/simulator/quotients.hpp"

namespace features {
namespace {

struct Rule {
    std::string what;
    std::regex symbol;                    // of a function or table of the feature, demangled
    std::vector<std::string> users;       // the features that need it ...
    std::vector<std::string> given = {};  // ... if one of these is used too; empty: always
};

const std::vector<std::string> links = {"SPRINGS", "ANCHORED_SPRINGS", "RODS", "ANCHORED_RODS",
                                        "ROPES",   "ANCHORED_ROPES"};

const std::vector<std::string> constraints = {"RODS",           "ANCHORED_RODS", "ROPES",
                                              "ANCHORED_ROPES", "PLANES",        "COLLISIONS"};
const std::string pull = "apply|ImplicitSprings::pull|CoupledSprings<.*>::collect";

std::vector<std::string> links_and(std::initializer_list<std::string> more) {
    std::vector<std::string> users = links;
    users.insert(users.end(), more);
    return users;
}

std::regex acts(const std::string& function, const std::string& on) {
    return std::regex("^(void )?engine::(" + function + ")<.*>\\(engine::" + on);
}
std::regex constrains(const std::string& link) {
    return std::regex("::Constrain<.*>::operator\\(\\)<engine::" + link);
}
std::regex begins(const std::string& text) { return std::regex("^(void |bool )?" + text); }

const std::vector<Rule>& rules() {
    static const std::vector<Rule> all = {
        {"gravity", begins("engine::Gravity<.*, true>::fall"), {"GRAVITY"}},
        {"springs", acts(pull, "Spring<.*Between<"), {"SPRINGS"}},
        {"anchored springs", acts(pull, "Spring<.*Anchored<"), {"ANCHORED_SPRINGS"}},
        {"drag", acts("apply", "Drag<"), {"DRAG"}},
        {"rods", constrains("Rod<.*Between<"), {"RODS"}},
        {"anchored rods", constrains("Rod<.*Anchored<"), {"ANCHORED_RODS"}},
        {"ropes", constrains("Rope<.*Between<"), {"ROPES"}},
        {"anchored ropes", constrains("Rope<.*Anchored<"), {"ANCHORED_ROPES"}},
        {"planes", std::regex("::ConstrainAll<.*>::operator\\(\\)"), {"PLANES"}},
        {"collisions", std::regex("(BruteForce|SortAndSweep)::collide_all"), {"COLLISIONS"}},
        {"contacts", std::regex("::contact<"), {"PLANES", "COLLISIONS"}},
        {"damping", begins("engine::OnlyIfTrue<true>::call<.*::damp\\(\\)"), {"DAMPING"}},
        {"a custom force", begins("Push<.*>::apply"), {"CUSTOM_FORCE"}},
        {"a third dimension", begins("engine::Vector<.*, 3>::"), {"3"}},
        {"explicit Euler", begins("engine::ExplicitEuler::"), {"ExplicitEuler"}},
        {"velocity Verlet", begins("engine::VelocityVerlet::"), {"VelocityVerlet"}},
        {"springs solved together",
         std::regex("engine::Elimination::couple<.*(DirectSprings|ImplicitMidpoint)::Row<"),
         {"DirectSprings", "ImplicitMidpoint"},
         {"SPRINGS", "ANCHORED_SPRINGS"}},
        {"compensated integration",
         std::regex("engine::carried_shift<"),
         {"CompensatedIntegration"}},
        {"projected_gauss_seidel",
         std::regex("engine::ProjectedGaussSeidel<.*>::(solve<|bind<.*If<false>\\))"),
         {"ProjectedGaussSeidel<10>"},
         constraints},
        {"direct rods",
         std::regex("engine::Elimination::couple<.*DirectRods::Row<"),
         {"DirectRods"},
         constraints},
        {"warm_started",
         std::regex("engine::WarmStartedGaussSeidel<.*>::solve<"),
         {"WarmStartedGaussSeidel<10>"},
         constraints},
        {"worst first",
         std::regex("engine::WorstFirst<.*>::solve<"),
         {"WorstFirst<10>"},
         constraints},
        {"continuous contacts", std::regex("engine::Flight<"), {"ContinuousContacts"}},
        {"sort and sweep",
         std::regex("engine::SortAndSweep::collide_all"),
         {"SortAndSweep"},
         {"COLLISIONS"}},
        {"cached sort and sweep",
         std::regex("engine::CachedSortAndSweep::collide_all"),
         {"CachedSortAndSweep"},
         {"COLLISIONS"}},
        // Sharing by mass between two particles takes a quotient, and so does a bounce off a plane:
        // the small one, without a table. WorstFirst divides by both.
        {"division",
         std::regex("fixedpoint_(divide|reciprocal_table)"),
         {"SPRINGS", "ANCHORED_SPRINGS", "RODS", "ROPES", "PLANES", "COLLISIONS",
          "WorstFirst<10>"}},
        {"the quotient by a table",
         std::regex("^fixedpoint_divide_q16_16$"),
         {"SPRINGS", "ANCHORED_SPRINGS", "ContinuousContacts", "WorstFirst<10>", "DirectRods"},
         {"Nearest"}},
        {"lengths",
         std::regex("fixedpoint_(length|sqrt_table)"),
         {"SPRINGS", "ANCHORED_SPRINGS", "DRAG", "ContinuousContacts"}},
        {"dot products", std::regex("fixedpoint_dot"), links_and({"PLANES", "COLLISIONS"})},
        {"square roots", std::regex("^fixedpoint_sqrt_q"), {"ContinuousContacts"}, {"COLLISIONS"}},
        {"floating point", std::regex("^__\\w+(sf|df)\\d?$"), {}},
        {"the compiler's quotients", std::regex(simulator::compilers_quotient), {}},
        {"64-bit integers", std::regex("^__\\w+di3?(_\\w+)?$"), {}},
        {"the heap", std::regex("^(malloc|free|operator (new|delete))"), {}},
        {"constructors at start-up", std::regex("^_GLOBAL__sub_I"), {}},
    };
    return all;
}

bool used(const Rule& rule, const Uses& uses) {
    const auto is_used = [&](const std::string& name) { return uses.contains(name); };
    return std::ranges::any_of(rule.users, is_used) &&
           (rule.given.empty() || std::ranges::any_of(rule.given, is_used));
}

std::string demangled(const std::string& name) {
    int status = 0;
    const std::unique_ptr<char, decltype(&std::free)> text(
        abi::__cxa_demangle(name.c_str(), nullptr, nullptr, &status), &std::free);
    return status == 0 ? text.get() : name;
}

std::vector<std::string> symbols(const simulator::Elf& elf) {
    std::vector<std::string> names;
    for (const auto* group : {&elf.functions(), &elf.objects()})
        for (const auto& [name, symbol] : *group) names.push_back(demangled(name));
    return names;
}

}  // namespace

std::vector<std::string> unneeded(const simulator::Elf& elf, const Uses& uses) {
    std::vector<std::string> found;
    const auto names = symbols(elf);
    for (const Rule& rule : rules()) {
        if (used(rule, uses)) continue;
        for (const auto& name : names)
            if (std::regex_search(name, rule.symbol)) found.push_back(name + " of " + rule.what);
    }
    return found;
}

std::vector<std::string> missing(const simulator::Elf& elf, const Uses& uses) {
    std::vector<std::string> absent;
    const auto names = symbols(elf);
    for (const Rule& rule : rules()) {
        if (!used(rule, uses)) continue;
        bool present = false;
        for (const auto& name : names) present |= std::regex_search(name, rule.symbol);
        if (!present) absent.push_back(rule.what);
    }
    return absent;
}

}  // namespace features
