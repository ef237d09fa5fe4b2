// SPDX-License-Identifier: MIT
// The evaluations of elementary_functions.hpp. All are templates: a program pays only for those it
// calls.
#pragma once

#include <fixedpoint/portable/arc_sines.hpp>
#include <fixedpoint/portable/elementary_functions.hpp>
#include <fixedpoint/portable/exponentials.hpp>
#include <fixedpoint/portable/logarithms.hpp>
#include <fixedpoint/portable/powers.hpp>
#include <fixedpoint/portable/tan.hpp>
