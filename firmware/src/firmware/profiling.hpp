// SPDX-License-Identifier: MIT
// Profiling by pins: a pin is high while its category runs, 2 cycles at either end. A category
// that the board's configuration does not name in `profiled` compiles to nothing.
#pragma once

#include <firmware/configuration.hpp>

namespace firmware {

// From here to the end of the block. A category within itself ends with the inner block.
template <class Board, Category category>
class Profiled {
  public:
    Profiled() { Board::template raise<category>(); }
    ~Profiled() { Board::template lower<category>(); }
    Profiled(const Profiled&) = delete;
    Profiled& operator=(const Profiled&) = delete;
};

// An arithmetic for Fixed whose multiplications and divisions raise the pin of `operation`, and
// whose square roots raise that of `square_root`.
template <class Board, class Arithmetic>
struct ProfiledArithmetic : Arithmetic {
    template <class Raw, int F>
    static Raw multiply(Raw a, Raw b) {
        const Profiled<Board, Category::operation> profiled;
        return Arithmetic::template multiply<Raw, F>(a, b);
    }
    template <class Raw, int F>
    static Raw divide(Raw a, Raw b) {
        const Profiled<Board, Category::operation> profiled;
        return Arithmetic::template divide<Raw, F>(a, b);
    }
    template <class Raw, int F>
    static Raw sqrt(Raw a) {
        const Profiled<Board, Category::square_root> profiled;
        return Arithmetic::template sqrt<Raw, F>(a);
    }
};

}  // namespace firmware
