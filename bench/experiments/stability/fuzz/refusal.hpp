// SPDX-License-Identifier: GPL-3.0-or-later
// What the fuzzers of text share: bad input must be refused by an exception of one line, and
// nothing else may happen.
#pragma once

#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace fuzz {

inline void check(bool holds, const char* what) {
    if (holds) return;
    std::fprintf(stderr, "%s\n", what);
    std::abort();
}

// Whether the function accepted its input.
template <class Function>
bool takes(Function function) {
    try {
        function();
        return true;
    } catch (const std::exception& error) {
        const std::string_view text = error.what();
        check(text.find('\n') == text.npos, "an error of more than one line");
        check(text.size() > 10 && text.find(' ') != text.npos, "an error that says nothing");
        return false;
    }
}

// In memory if there is such a folder, since thousands of files a second are written.
inline std::filesystem::path temporary() {
    const std::filesystem::path in_memory = "/dev/shm";
    return std::filesystem::is_directory(in_memory) ? in_memory
                                                    : std::filesystem::temp_directory_path();
}
// A folder for this process.
inline const std::filesystem::path& folder() {
    static const std::filesystem::path made = [] {
        const auto path = temporary() / ("fuzz." + std::to_string(getpid()));
        std::filesystem::create_directory(path);
        std::atexit([] {
            std::error_code ignored;
            std::filesystem::remove_all(folder(), ignored);
        });
        return path;
    }();
    return made;
}
// A file in that folder that contains the text.
inline std::filesystem::path file(const char* name, std::string_view text) {
    const std::filesystem::path path = folder() / name;
    std::ofstream(path, std::ios::binary | std::ios::trunc)
        .write(text.data(), static_cast<std::streamsize>(text.size()));
    return path;
}

}  // namespace fuzz
