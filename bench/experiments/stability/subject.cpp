// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/stability/subject.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace stability {

const std::vector<Subject>& subjects() {
    static const std::vector<Subject> all = [] {
        std::vector<Subject> list;
#define SUBJECTS_OF(format, I, F) subjects_of_##format,
        for (const auto part : {STABILITY_FORMATS(SUBJECTS_OF) subjects_of_float,
                                subjects_of_q16_16_published, subjects_of_q16_16_saturating})
#undef SUBJECTS_OF
            for (Subject& one : part()) list.push_back(std::move(one));
        return list;
    }();
    return all;
}

const std::vector<Subject>& more_subjects() {
    static const std::vector<Subject> all = [] {
        std::vector<Subject> list = subjects_of_chains();
        for (Subject& one : subjects_of_continuous_contacts()) list.push_back(std::move(one));
        return list;
    }();
    return all;
}

const Subject& subject(const std::string& scalar, const std::string& arithmetic,
                       const std::string& integrator) {
    static const std::vector<Subject> ablated = subjects_of_ablated();
    static const std::vector<Subject> of_features = subjects_of_features();
    for (const auto* list : {&subjects(), &more_subjects(), &ablated, &of_features})
        for (const Subject& one : *list)
            if (one.scalar == scalar && one.arithmetic == arithmetic &&
                one.integrator == integrator)
                return one;
    throw std::runtime_error(fmt::format("no subject {} {} {}", scalar, arithmetic, integrator));
}

}  // namespace stability
