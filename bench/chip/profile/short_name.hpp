// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace profile {

// A C++ function as a reader would call it: class and name, without namespaces, arguments and
// return type. Overloads and instances of a template share it. Other names are unchanged.
std::string short_name(std::string_view name);

}  // namespace profile
