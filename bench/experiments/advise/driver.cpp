// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/advise/driver.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "bench/lab/program/run.hpp"
#include "this_build.hpp"

namespace advise {
namespace {

namespace fs = std::filesystem;

const fs::path driver_folder = source_folder() / "bench/experiments/advise/driver";

// The compiler's first error, or else its first line. Without colours, since it does not write to a
// terminal.
std::string first_error(const std::string& text) {
    std::string first;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string line = text.substr(begin, end - begin);
        if (line.find("error: ") != line.npos || line.find("undefined reference") != line.npos ||
            line.find("overflowed by") != line.npos)
            return line;
        if (first.empty()) first = line;
        begin = end + 1;
    }
    return first;
}

// Compiles a file of the driver with the user's program.
void compile(std::vector<std::string> command, const fs::path& program, const char* driver,
             const fs::path& output) {
    command.insert(command.end(), {"-I", source_folder(), "-I", source_folder() / "fixedpoint/src",
                                   "-I", source_folder() / "engine/src",
                                   fmt::format("-DPROGRAM=\"{}\"", program.string()),
                                   driver_folder / driver, "-o", output});
    if (std::string(driver) == "chip.cpp")
        command.insert(command.end(), {build_folder() / "kernels.a", "-lm"});
    const fixbench::Ran ran = fixbench::run(command);
    if (!ran.succeeded)
        throw Failure(
            fmt::format("{} does not compile: {}", program.string(), first_error(ran.err)));
}

}  // namespace

void compile_for_host(const fs::path& program, const char* driver,
                      const std::vector<std::string>& options, const fs::path& output) {
    std::vector<std::string> command = {cxx_compiler(), "-std=c++20", "-O1", "-w"};
    command.insert(command.end(), options.begin(), options.end());
    compile(command, program, driver, output);
}

void compile_for_chip(const fs::path& program, const std::vector<std::string>& definitions,
                      const fs::path& output) {
    std::vector<std::string> command = {"avr-g++",
                                        "-mmcu=atmega328p",
                                        "-DF_CPU=16000000UL",
                                        "-Os",
                                        "-std=gnu++14",
                                        "-w",
                                        "-fno-exceptions",
                                        "-fno-rtti",
                                        "-fno-threadsafe-statics",
                                        "-ffunction-sections",
                                        "-fdata-sections",
                                        "-fshort-enums",
                                        "-Wl,--gc-sections,-u,advise_step"};
    command.insert(command.end(), definitions.begin(), definitions.end());
    compile(command, program, "chip.cpp", output);
}

std::vector<Words> lines_of(const fs::path& user, std::vector<std::string> command) {
    constexpr const char* limit = "60";  // s
    command.insert(command.begin(), {"timeout", limit});
    const fixbench::Ran ran = fixbench::run(command);
    if (!ran.succeeded)
        throw std::invalid_argument(fmt::format(
            "{}: crashes on the host, or is not done after {} s", user.string(), limit));
    std::vector<Words> lines;
    for (std::size_t begin = 0; begin < ran.out.size();) {
        const std::size_t end = ran.out.find('\n', begin);
        Words& words = lines.emplace_back();
        for (std::size_t at = begin; at <= end;) {
            const std::size_t tab = std::min(ran.out.find('\t', at), end);
            words.push_back(ran.out.substr(at, tab - at));
            at = tab + 1;
        }
        begin = end + 1;
    }
    return lines;
}

}  // namespace advise
