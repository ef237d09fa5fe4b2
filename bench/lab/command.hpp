// SPDX-License-Identifier: GPL-3.0-or-later
// How a room of the bench offers a sub-command of fixbench: it adds a command to the app, whose
// callback sets the action that runs once the whole command line is read.
#pragma once

#include <functional>

namespace fixbench {

// What a sub-command returns: 0 only when everything asked for was done and every check held.
using Action = std::function<int()>;

}  // namespace fixbench
