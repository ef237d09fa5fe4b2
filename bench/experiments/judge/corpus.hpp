// SPDX-License-Identifier: GPL-3.0-or-later
// Operands worth trying for everybody's implementation, as files: the boundary table and the worst
// operands that were ever measured, each with why it is there. Lines as in pipe.hpp.
#pragma once

#include <filesystem>

namespace judge {

// Writes <operation>_<format>.txt for each operation and format of the library into `corpus`, with
// the worst operands of accuracy.csv, exhaustive.csv and operations.csv in `data`.
void write_corpora(const std::filesystem::path& data, const std::filesystem::path& corpus);

}  // namespace judge
