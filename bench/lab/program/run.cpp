// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/lab/program/run.hpp"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <memory>
#include <stdexcept>

namespace fixbench {
namespace {

// A file without a name: unlike a pipe, it takes all output while nobody reads.
class Output {
  public:
    Output() : file_(std::tmpfile(), std::fclose) {
        if (!file_) throw std::runtime_error("cannot make a temporary file");
    }
    int descriptor() const { return fileno(file_.get()); }
    std::string text() const {
        if (std::fseek(file_.get(), 0, SEEK_SET) != 0)
            throw std::runtime_error("cannot read a temporary file");
        std::string text;
        char block[65536];
        for (std::size_t n; (n = std::fread(block, 1, sizeof block, file_.get())) > 0;)
            text.append(block, n);
        return text;
    }

  private:
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
};

}  // namespace

Ran run(std::vector<std::string> arguments) {
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    const Output out, err;
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, out.descriptor(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files, err.descriptor(), STDERR_FILENO);
    pid_t child;
    int status = -1;
    const bool started =
        posix_spawnp(&child, pointers[0], &files, nullptr, pointers.data(), environ) == 0;
    posix_spawn_file_actions_destroy(&files);
    if (!started) return {false, "", "cannot run " + arguments[0]};
    if (waitpid(child, &status, 0) < 0) status = -1;
    return {status == 0, out.text(), err.text()};
}

}  // namespace fixbench
