// SPDX-License-Identifier: GPL-3.0-or-later
// The manual page and the shell completion, generated from the command line itself.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace sequence {

std::string bash_completion(const CLI::App& app);
std::string manual_page(const CLI::App& app);  // man(7), section 1

}  // namespace sequence
