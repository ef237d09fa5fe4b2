// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace profile {

// A C++ function as its reader calls it: its class and its name, without namespaces, arguments and
// return type. Overloads and instances of a template share it. Other names stay as they are.
std::string short_name(std::string_view name);

}  // namespace profile
