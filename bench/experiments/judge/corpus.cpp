// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/judge/corpus.hpp"

#include <fmt/format.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "bench/experiments/judge/claim.hpp"
#include "bench/lab/catalogue/subjects.h"
#include "bench/lab/records/csv.hpp"
#include "bench/lab/records/whole_file.hpp"

namespace judge {
namespace {

namespace fs = std::filesystem;

// There are tens of thousands of pairs in a table: a file contains this many of them, taken evenly,
// in addition to all ties and the worst operands.
constexpr std::size_t max_boundary_cases = 300;

// By operation and format: the operands as text, and why they are included. Of equal operands the
// first reason is kept.
using Subject = std::pair<std::string, std::string>;
using Worst = std::map<Subject, std::vector<std::pair<std::string, std::string>>>;

struct Source {
    const char* file;
    const char* column;
    const char* why;  // followed by the implementation
};
constexpr Source sources[] = {
    {"exhaustive.csv", "max_ulp_witness", "the largest error known of"},
    {"accuracy.csv", "max_ulp_witness", "the largest error known of"},
    {"operations.csv", "max_ulp_witness", "a large error of"},
    {"exhaustive.csv", "cycles_max_witness", "the most cycles known of"},
    {"operations.csv", "cycles_max_witness", "many cycles of"},
};

Worst worst_of(const fs::path& data) {
    Worst worst;
    for (const Source& source : sources) {
        if (!fs::exists(data / source.file)) continue;
        const records::Table table = records::Table::load(data / source.file);
        const std::size_t operation = table.column("operation"), format = table.column("format"),
                          implementation = table.column("implementation"),
                          witness = table.column(source.column);
        for (const auto& row : table.rows())
            if (!row[witness].empty())
                worst[{row[operation], row[format]}].emplace_back(
                    row[witness], fmt::format("{} {}", source.why, row[implementation]));
    }
    return worst;
}

std::string corpus_of(const Subject& subject, const Worst& worst) {
    const auto& [operation, format] = subject;
    const auto claim = parse_claim(operation + ":" + format);
    std::string text = fmt::format(
        "# SPDX-License-Identifier: GPL-3.0-or-later\n"
        "# {0} of {1}: raw operands, and why they are there. DO NOT EDIT: `fixbench corpus` writes "
        "this file.\n"
        "# sed 's/#.*//' FILE | ./yours | fixbench judge --pipe --as {0}:{1}\n",
        operation, format);
    std::set<std::string> taken;
    const auto add = [&](const std::string& operands, const std::string& why) {
        if (taken.insert(operands).second) text += operands + " # " + why + "\n";
    };
    if (const auto found = worst.find(subject); found != worst.end())
        for (const auto& [operands, why] : found->second) add(operands, why);
    const auto cases = claim->boundary_cases();
    const std::size_t count = std::min(cases.size(), max_boundary_cases);
    for (std::size_t i = 0; i < count; ++i) {
        const operands::BoundaryCase& each = cases[i * cases.size() / count];
        add(text_of(*claim, each.operands), each.what);
    }
    return text;
}

}  // namespace

void write_corpora(const fs::path& data, const fs::path& corpus) {
    const Worst worst = worst_of(data);
#define ADD_OPERATION(operation, ...) operations.emplace_back(#operation);
#define ADD_FORMAT(format, ...) formats.emplace_back(#format);
    std::vector<std::string> operations, formats;
    MEASURED_OPERATIONS(ADD_OPERATION)
    LIBRARY_FORMATS(ADD_FORMAT)
    for (const std::string& operation : operations)
        for (const std::string& format : formats)
            records::write_whole(corpus / fmt::format("{}_{}.txt", operation, format),
                                 corpus_of({operation, format}, worst));
}

}  // namespace judge
