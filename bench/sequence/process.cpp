// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/sequence/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstring>
#include <ctime>
#include <stdexcept>

namespace sequence {
namespace {

double seconds(const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
}

}  // namespace

Process::Process(const std::vector<std::string>& command, const std::filesystem::path& folder,
                 const std::filesystem::path& log, const lab::Pool* pool) {
    std::vector<char*> arguments;
    for (const std::string& argument : command)
        arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    const int out = open(log.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0666);
    if (out < 0)
        throw std::runtime_error(
            fmt::format("cannot write {}: {}", log.string(), std::strerror(errno)));
    const std::string ends =
        pool ? fmt::format("{},{}", pool->read_end(), pool->write_end()) : std::string();
    const pid_t parent = getpid();
    pid_ = fork();
    if (pid_ < 0) throw std::runtime_error("cannot start a process");
    if (pid_ == 0) {
        // A process group of its own: Ctrl-C reaches the process that shows the progress, which
        // ends the others.
        setpgid(0, 0);
        prctl(PR_SET_PDEATHSIG, SIGTERM);
        if (getppid() != parent) _exit(127);
        const int in = open("/dev/null", O_RDONLY);
        dup2(in, STDIN_FILENO);
        dup2(out, STDOUT_FILENO);
        dup2(out, STDERR_FILENO);
        if (pool)
            setenv(lab::Pool::variable, ends.c_str(), 1);
        else
            unsetenv(lab::Pool::variable);
        if (chdir(folder.c_str()) == 0) execv(arguments[0], arguments.data());
        const std::string cause = fmt::format("cannot run {}: {}\n", command[0], strerror(errno));
        [[maybe_unused]] const auto written = write(STDERR_FILENO, cause.data(), cause.size());
        _exit(127);
    }
    close(out);
    setpgid(pid_, pid_);
}

std::optional<int> Process::ended() {
    if (status_) return status_;
    int status;
    rusage usage;
    if (wait4(pid_, &status, WNOHANG, &usage) != pid_) return std::nullopt;
    total_ = seconds(usage.ru_utime) + seconds(usage.ru_stime);
    status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return status_;
}

double Process::cpu_seconds() const {
    if (status_) return total_;
    clockid_t clock;
    timespec time;
    if (clock_getcpuclockid(pid_, &clock) != 0 || clock_gettime(clock, &time) != 0) return 0;
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

void Process::stop() {
    if (status_) return;
    kill(-pid_, SIGTERM);
    while (!ended()) usleep(10'000);
}

}  // namespace sequence
