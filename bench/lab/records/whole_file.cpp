// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/lab/records/whole_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace records {

void write_whole(const std::filesystem::path& path, std::string_view content) {
    std::error_code error;
    if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
    static std::atomic<unsigned> count = 0;  // threads may write the same file
    std::filesystem::path partial = path;
    partial += fmt::format(".partial.{}.{}", getpid(), count++);
    std::ofstream stream(partial, std::ios::binary);
    stream.write(content.data(), static_cast<std::streamsize>(content.size()));
    stream.close();
    if (!stream) {
        const int cause = errno;
        std::filesystem::remove(partial, error);
        throw std::runtime_error(
            fmt::format("cannot write {}: {}", path.string(), std::strerror(cause)));
    }
    std::filesystem::rename(partial, path, error);
    if (error) {
        const std::string cause = error.message();
        std::filesystem::remove(partial, error);
        throw std::runtime_error(fmt::format("cannot write {}: {}", path.string(), cause));
    }
}

}  // namespace records
