// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/lab/program/build.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "bench/lab/pool.hpp"

namespace fixbench {
namespace {

// One build at a time: two would write the same files.
class Lock {
  public:
    Lock()
        : file_(open(FIXBENCH_BUILD_FOLDER "/.fixbench.lock", O_CREAT | O_RDWR | O_CLOEXEC, 0666)) {
        if (file_ < 0 || flock(file_, LOCK_EX) != 0)
            throw std::runtime_error("cannot lock the build folder " FIXBENCH_BUILD_FOLDER);
    }
    ~Lock() { close(file_); }
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

  private:
    int file_;
};

// What the command printed, and whether it succeeded.
std::pair<std::string, bool> output_of(const std::string& command) {
    FILE* const pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return {"", false};
    std::string text;
    std::array<char, 4096> part;
    while (const std::size_t size = fread(part.data(), 1, part.size(), pipe))
        text.append(part.data(), size);
    return {text, pclose(pipe) == 0};
}

}  // namespace

void build(const std::vector<std::string>& targets) {
    if (targets.empty() || lab::Pool::shared() != nullptr) return;
    const Lock lock;
    std::string list;
    for (const std::string& target : targets) {
        // Ninja names files by their path in the build folder.
        const auto path = std::filesystem::path(target).lexically_relative(FIXBENCH_BUILD_FOLDER);
        const bool below = std::filesystem::path(target).is_absolute() && !path.empty();
        list += fmt::format(" '{}'", below ? path.string() : target);
    }
    const std::string ninja = "ninja -C '" FIXBENCH_BUILD_FOLDER "'";
    const auto [plan, planned] = output_of(ninja + " -n" + list + " 2>&1");
    if (planned && plan.find("no work to do") != std::string::npos) return;
    fmt::print(stderr, "fixbench: building {}, for what it reads is out of date\n",
               targets.size() == 1 ? targets.front() : fmt::format("{} targets", targets.size()));
    const auto [text, built] = output_of(ninja + list + " 2>&1");
    if (!built) {
        fmt::print(stderr, "{}", text);
        throw std::runtime_error("the device programs cannot be built");
    }
}

}  // namespace fixbench
