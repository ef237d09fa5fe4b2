// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/compare/compare.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include "bench/lab/program/run.hpp"

namespace compare {
namespace {

namespace fs = std::filesystem;

// Quantities of which less is better.
struct Quantity {
    const char* column;
    bool depends_on_samples;
};
constexpr Quantity quantities[] = {
    {"cycles_mean", true},  {"cycles_max", true}, {"max_ulp", true},     {"rms_ulp", true},
    {"flash_bytes", false}, {"ram_bytes", false}, {"stack_bytes", true}, {"violations", true}};

using Key = std::array<std::string, 4>;  // operation, format, implementation, operands

class Run {
  public:
    explicit Run(const records::Table& table) : table_(table) {
        std::array<std::size_t, 4> columns;
        for (std::size_t i = 0;
             const char* name : {"operation", "format", "implementation", "operands"})
            columns[i++] = table.column(name);
        for (const auto& row : table.rows()) {
            keys_.push_back({row[columns[0]], row[columns[1]], row[columns[2]], row[columns[3]]});
            rows_[keys_.back()] = &row;
        }
    }
    const std::vector<Key>& keys() const { return keys_; }
    bool has(const Key& key) const { return rows_.contains(key); }
    std::optional<double> value(const Key& key, const char* column) const {
        const auto row = rows_.find(key);
        if (row == rows_.end()) return {};
        const std::string& cell = (*row->second)[table_.column(column)];
        if (cell.empty()) return {};
        try {
            return std::stod(cell);
        } catch (const std::exception&) {
            throw std::invalid_argument(
                fmt::format("operations.csv: '{}' of {} is not a number", cell, column));
        }
    }

  private:
    const records::Table& table_;
    std::vector<Key> keys_;
    std::map<Key, const std::vector<std::string>*> rows_;
};

Change change_of(const Key& key, const char* quantity) {
    Change change;
    change.operation = key[0];
    change.format = key[1];
    change.implementation = key[2];
    change.operands = key[3];
    change.quantity = quantity;
    return change;
}

// The operations of the score. Sums are exact in fixed point and have no error to compare.
constexpr const char* scored[] = {"add",   "multiply", "divide", "sqrt", "sin",
                                  "atan2", "exp",      "log",    "dot3", "length3"};
struct Part {
    const char* column;
    const char* name;
};
constexpr Part parts[] = {{"cycles_mean", "cycles, times better than float"},
                          {"flash_bytes", "flash, times better than float"},
                          {"rms_error", "error, times better than float"}};

std::optional<double> advantage(const Run& run, const char* operation, const char* column) {
    const auto ours = run.value({operation, "q16_16", "default", "physics"}, column);
    const auto theirs = run.value({operation, "float", "libc", "physics"}, column);
    if (!ours || !theirs || *ours <= 0 || *theirs <= 0) return {};
    return *theirs / *ours;
}

std::optional<double> geometric_mean(const std::vector<std::optional<double>>& ratios) {
    double sum = 0;
    int count = 0;
    for (const auto& ratio : ratios) {
        if (!ratio) continue;
        sum += std::log(*ratio);
        ++count;
    }
    return count ? std::optional(std::exp(sum / count)) : std::nullopt;
}

void settle(Change& change) {
    if (change.before && change.after && *change.before != *change.after)
        change.verdict = *change.after < *change.before ? "worse" : "better";
}

}  // namespace

records::Table operations_of(const std::string& folder_or_revision, const fs::path& repository) {
    if (fs::is_directory(folder_or_revision)) {
        for (const char* file : {"operations.csv", "data/operations.csv"})
            if (fs::exists(fs::path(folder_or_revision) / file))
                return records::Table::load(fs::path(folder_or_revision) / file);
        throw std::invalid_argument(
            fmt::format("{} holds neither operations.csv nor data/operations.csv: `fixbench "
                        "cycles --output {}` writes it",
                        folder_or_revision, folder_or_revision));
    }
    const std::string name = "results/data/operations.csv";
    const fixbench::Ran shown =
        fixbench::run({"git", "-C", repository.string(), "show", "--end-of-options",
                       folder_or_revision + ":" + name});
    if (!shown.succeeded)
        throw std::invalid_argument(fmt::format(
            "'{}' is neither a folder nor a git revision with {}", folder_or_revision, name));
    return records::Table::parse(shown.out, folder_or_revision + ":" + name);
}

std::vector<Change> changes(const records::Table& before, const records::Table& after) {
    const Run earlier(before), later(after);
    std::vector<Change> found;
    for (const Key& key : later.keys()) {
        if (!earlier.has(key)) {
            found.push_back(change_of(key, "subject"));
            found.back().verdict = "new";
            continue;
        }
        const bool same_samples = earlier.value(key, "samples") == later.value(key, "samples");
        for (const Quantity& quantity : quantities) {
            if (quantity.depends_on_samples && !same_samples) continue;
            Change change = change_of(key, quantity.column);
            change.before = earlier.value(key, quantity.column);
            change.after = later.value(key, quantity.column);
            if (!change.before || !change.after || *change.before == *change.after) continue;
            change.verdict = *change.after > *change.before ? "worse" : "better";
            found.push_back(std::move(change));
        }
    }
    for (const Key& key : earlier.keys()) {
        if (later.has(key)) continue;
        found.push_back(change_of(key, "subject"));
        found.back().verdict = "gone";
    }
    return found;
}

std::vector<Change> score(const records::Table& before, const records::Table& after) {
    const Run earlier(before), later(after);
    std::vector<Change> rows, means;
    std::vector<std::optional<double>> scores_before, scores_after;
    for (const Part& part : parts) {
        std::vector<std::optional<double>> ratios_before, ratios_after;
        for (const char* operation : scored) {
            Change row = change_of({operation, "q16_16", "default", "physics"}, part.name);
            row.before = advantage(earlier, operation, part.column);
            row.after = advantage(later, operation, part.column);
            if (!row.before && !row.after) continue;
            ratios_before.push_back(row.before);
            ratios_after.push_back(row.after);
            settle(row);
            rows.push_back(std::move(row));
        }
        Change mean = change_of({"mean", "q16_16", "default", "physics"}, part.name);
        mean.before = geometric_mean(ratios_before);
        mean.after = geometric_mean(ratios_after);
        settle(mean);
        scores_before.push_back(mean.before);
        scores_after.push_back(mean.after);
        means.push_back(std::move(mean));
    }
    rows.insert(rows.end(), means.begin(), means.end());
    Change total = change_of({"score", "q16_16", "default", "physics"},
                             "geometric mean of cycles, flash and error");
    total.before = geometric_mean(scores_before);
    total.after = geometric_mean(scores_after);
    settle(total);
    rows.push_back(std::move(total));
    return rows;
}

}  // namespace compare
