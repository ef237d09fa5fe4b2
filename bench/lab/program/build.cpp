// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/lab/program/build.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <functional>
#include <stdexcept>

#include "bench/lab/pool.hpp"
#include "this_build.hpp"

namespace fixbench {
namespace {

// One build at a time: two would write the same files.
class Lock {
  public:
    Lock()
        : file_(open((build_folder() / ".fixbench.lock").c_str(), O_CREAT | O_RDWR | O_CLOEXEC,
                     0666)) {
        if (file_ < 0 || flock(file_, LOCK_EX) != 0)
            throw std::runtime_error("cannot lock the build folder " + build_folder().string());
    }
    ~Lock() { close(file_); }
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

  private:
    int file_;
};

// A line in which ninja reports a step, other than the steps that look for new sources.
bool is_step(const std::string& line) {
    return line.starts_with('[') && line.find("Re-checking globbed") == line.npos &&
           line.find("Re-running CMake") == line.npos;
}

// What the command printed, and whether it succeeded. Calls `at_first_step` when the first step
// shows that there is something to do. A dry run cannot tell: ninja always considers globbed
// folders out of date.
std::pair<std::string, bool> run(const std::string& command,
                                 const std::function<void()>& at_first_step) {
    FILE* const pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return {"", false};
    std::string text, line;
    bool stepped = false;
    for (int c; (c = std::fgetc(pipe)) != EOF;) {
        text += static_cast<char>(c);
        line += static_cast<char>(c);
        if (c != '\n') continue;
        if (!stepped && is_step(line)) {
            stepped = true;
            at_first_step();
        }
        line.clear();
    }
    return {text, pclose(pipe) == 0};
}

}  // namespace

void build(const std::vector<std::string>& targets) {
    if (targets.empty() || lab::Pool::shared() != nullptr) return;
    const Lock lock;
    std::string list;
    for (const std::string& target : targets) {
        // Ninja names files by their path in the build folder.
        const auto path = std::filesystem::path(target).lexically_relative(build_folder());
        const bool below = std::filesystem::path(target).is_absolute() && !path.empty();
        list += fmt::format(" '{}'", below ? path.string() : target);
    }
    const auto [text, built] =
        run("ninja -C '" + build_folder().string() + "'" + list + " 2>&1", [&] {
            fmt::print(
                stderr, "fixbench: building {}, out of date\n",
                targets.size() == 1 ? targets.front() : fmt::format("{} targets", targets.size()));
        });
    if (!built) {
        fmt::print(stderr, "{}", text);
        throw std::runtime_error("the device programs do not build");
    }
}

}  // namespace fixbench
