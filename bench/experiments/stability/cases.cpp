// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/cases.hpp"

#include <stdexcept>
#include <utility>

namespace stability {

const std::vector<Case>& all_cases() {
    static const std::vector<Case> all = [] {
        std::vector<Case> list;
        for (const auto part : {spring_cases, link_cases, contact_cases, edge_cases})
            for (Case& one : part()) list.push_back(std::move(one));
        return list;
    }();
    return all;
}

const Case& case_named(const std::string& name) {
    for (const Case& one : all_cases())
        if (one.name == name) return one;
    throw std::logic_error("no case " + name);
}

}  // namespace stability
