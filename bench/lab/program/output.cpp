// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/lab/program/output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bench/lab/program/scratch.hpp"
#include "bench/lab/records/csv.hpp"
#include "bench/lab/records/whole_file.hpp"

namespace fixbench {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

// Columns side by side, numbers aligned to the right; columns without a value are left out.
std::string aligned(const records::Table& table) {
    const auto is_number = [](const std::string& cell) {
        return cell.empty() || cell.find_first_not_of("0123456789.+-e") == std::string::npos;
    };
    // Counts characters of UTF-8, not bytes.
    const auto length = [](const std::string& cell) {
        return static_cast<std::size_t>(
            std::count_if(cell.begin(), cell.end(), [](char c) { return (c & 0xc0) != 0x80; }));
    };
    std::vector<std::size_t> widths;
    std::vector<bool> right;
    for (std::size_t k = 0; k < table.columns().size(); ++k) {
        std::size_t width = 0;
        bool numbers = true;
        for (const auto& row : table.rows()) {
            width = std::max(width, length(row[k]));
            numbers &= is_number(row[k]);
        }
        widths.push_back(width == 0 ? 0 : std::max(width, length(table.columns()[k])));
        right.push_back(numbers);
    }
    std::string text;
    const auto add = [&](const std::vector<std::string>& cells) {
        std::string line;
        for (std::size_t k = 0; k < cells.size(); ++k) {
            if (widths[k] == 0) continue;
            const std::string space(widths[k] - length(cells[k]), ' ');
            line += right[k] ? space + cells[k] : cells[k] + space;
            line += "  ";
        }
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + '\n';
    };
    add(table.columns());
    for (const auto& row : table.rows()) add(row);
    return text;
}

nlohmann::ordered_json rows_of(const records::Table& table) {
    nlohmann::ordered_json rows = nlohmann::json::array();
    for (const auto& row : table.rows()) {
        nlohmann::ordered_json entry;
        for (std::size_t k = 0; k < row.size(); ++k) {
            const auto number = nlohmann::json::parse(row[k], nullptr, false);
            if (row[k].empty())
                entry[table.columns()[k]] = nullptr;
            else if (number.is_number())
                entry[table.columns()[k]] = number;
            else
                entry[table.columns()[k]] = row[k];
        }
        rows.push_back(std::move(entry));
    }
    return rows;
}

}  // namespace

void require_writable(const fs::path& folder) {
    // Folders that were created for the trial are removed again: a refused run leaves nothing
    // behind.
    std::vector<fs::path> made;
    std::error_code ignored;
    for (fs::path each = fs::absolute(folder);
         !fs::exists(each, ignored) && each.has_relative_path(); each = each.parent_path())
        made.push_back(each);
    const fs::path trial = folder / ".fixbench.trial";
    records::write_whole(trial, "");
    fs::remove(trial);
    for (const fs::path& each : made) fs::remove(each, ignored);
}

int Output::collect(const std::function<int(const fs::path&)>& measure) const {
    if (!folder.empty()) {
        if (json || csv)
            throw std::invalid_argument(
                "--json and --csv print the table and cannot be combined with --output");
        for (const std::string& name : prints)
            if (is_selection && fs::exists(folder / name))
                throw std::invalid_argument(
                    fmt::format("{} already exists, and a selection does not replace it: name "
                                "another folder, or print without --output",
                                (folder / name).string()));
        require_writable(folder);
        return measure(folder);
    }
    const Scratch scratch;
    const int result = measure(scratch.folder());
    for (const std::string& name : prints) {
        const fs::path file = scratch.folder() / name;
        if (!fs::exists(file)) continue;
        // If the experiment writes its own JSON, that is printed.
        fs::path document = file;
        document.replace_extension(".json");
        const bool tabular = file.extension() == ".csv";
        if (csv && !tabular)
            throw std::invalid_argument(
                fmt::format("--csv cannot print {}, which is not a table", name));
        if (csv || !tabular)
            fmt::print("{}", text_of(file));
        else if (json && fs::exists(document))
            fmt::print("{}", text_of(document));
        else if (json)
            fmt::print("{}\n", rows_of(records::Table::load(file)).dump(1));
        else
            fmt::print("{}", aligned(records::Table::load(file)));
        break;
    }
    return result;
}

}  // namespace fixbench
