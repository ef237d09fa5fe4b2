// SPDX-License-Identifier: GPL-3.0-or-later
// The cores that processes share. `fixbench all` starts experiments as processes and passes the
// pool to each, as make does with its jobserver: a byte in a pipe is the right to keep a core busy.
// A process has one such right as long as it lives; every further thread holds a byte while it
// works on a task. So the last experiment gets all cores.
#pragma once

#include <functional>

namespace lab {

class Pool {
  public:
    // The pool of the process that started this one; nullptr if it runs by itself.
    static Pool* shared();

    // A pool with that many cores. Child processes find it under `variable` in their environment.
    explicit Pool(unsigned cores);
    ~Pool();
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;

    bool try_take();
    // Waits for a core. Returns false as soon as `over` says that none is needed any more.
    bool take(const std::function<bool()>& over);
    void give_back();
    // Frees all cores, whatever a child that crashed took with it. No child may be running.
    void refill(unsigned cores);

    static constexpr const char* variable = "FIXBENCH_POOL";
    int read_end() const { return read_; }
    int write_end() const { return write_; }

  private:
    Pool(int read_end, int write_end) : read_(read_end), write_(write_end), owned_(false) {}
    int read_, write_;
    bool owned_;
};

}  // namespace lab
