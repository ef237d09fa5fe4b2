// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/sequence/times.hpp"

#include <fstream>
#include <nlohmann/json.hpp>

#include "bench/lab/records/whole_file.hpp"

namespace sequence {
namespace {

std::string key_of(const std::string& step, bool quick) {
    return (quick ? "quick/" : "full/") + step;
}

}  // namespace

Times::Times(std::filesystem::path file) : file_(std::move(file)) {
    std::ifstream stream(file_);
    const auto document = nlohmann::json::parse(stream, nullptr, false);
    if (!document.is_object()) return;
    for (const auto& [key, taken] : document.items()) {
        const auto seconds = [&](const char* name) {
            return taken.is_object() && taken.contains(name) && taken[name].is_number()
                       ? taken[name].get<double>()
                       : -1;
        };
        if (seconds("cpu") >= 0 && seconds("wall") >= 0)
            taken_[key] = {seconds("cpu"), seconds("wall")};
    }
}

std::optional<Taken> Times::of(const std::string& step, bool quick) const {
    const auto found = taken_.find(key_of(step, quick));
    if (found == taken_.end()) return std::nullopt;
    return found->second;
}

void Times::set(const std::string& step, bool quick, Taken taken) {
    taken_[key_of(step, quick)] = taken;
    nlohmann::json document;
    for (const auto& [key, each] : taken_) document[key] = {{"cpu", each.cpu}, {"wall", each.wall}};
    records::write_whole(file_, document.dump(1) + "\n");
}

}  // namespace sequence
