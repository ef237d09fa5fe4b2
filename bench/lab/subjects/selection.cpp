// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/lab/subjects/selection.hpp"

#include <algorithm>

namespace operations {

namespace {

bool holds(const std::vector<std::string>& list, std::string_view name) {
    return list.empty() || std::find(list.begin(), list.end(), name) != list.end();
}

}  // namespace

bool Selection::selects(const reference::Subject& subject, std::string_view implementation) const {
    return holds(operations, reference::shape(subject.operation).name) &&
           holds(formats, reference::format_name(subject.format)) &&
           holds(implementations, implementation);
}

bool Selection::selects_operands(std::string_view operand_class) const {
    return holds(operands, operand_class);
}

}  // namespace operations
