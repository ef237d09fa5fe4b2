// SPDX-License-Identifier: GPL-3.0-or-later
// Operands worth trying for every implementation, as files: the boundary table and the worst
// operands ever measured, each with the reason why it is included. Lines as in pipe.hpp.
#pragma once

#include <filesystem>

namespace judge {

// Writes <operation>_<format>.txt for each operation and format of the library into `corpus`, with
// the worst operands of accuracy.csv, exhaustive.csv and operations.csv in `data`.
void write_corpora(const std::filesystem::path& data, const std::filesystem::path& corpus);

}  // namespace judge
