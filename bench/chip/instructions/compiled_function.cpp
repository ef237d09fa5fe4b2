// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/instructions/compiled_function.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>
#include <sys/wait.h>

#include <fstream>
#include <iterator>
#include <sstream>

#include "bench/chip/simulator/chip.hpp"
#include "this_build.hpp"

extern char** environ;

namespace instructions {
namespace {

namespace fs = std::filesystem;

// A temporary folder, removed by the destructor.
class ScratchFolder {
  public:
    ScratchFolder() {
        std::string name = (fs::temp_directory_path() / "instructions-XXXXXX").string();
        if (!mkdtemp(name.data())) throw std::runtime_error(fmt::format("cannot make {}", name));
        path_ = name;
    }
    ~ScratchFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    ScratchFolder(const ScratchFolder&) = delete;
    fs::path operator/(const char* name) const { return path_ / name; }

  private:
    fs::path path_;
};

void compile(const fs::path& source, const fs::path& output, const fs::path& messages,
             const Compilation& compilation) {
    std::vector<std::string> words = {cxx_compiler(),
                                      "-std=c++20",
                                      "-shared",
                                      "-fPIC",
                                      "-w",
                                      "-I",
                                      compilation.include_folder.string()};
    std::istringstream options(compilation.options);
    words.insert(words.end(), std::istream_iterator<std::string>(options), {});
    words.insert(words.end(), {source.string(), "-o", output.string()});
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);

    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 2, messages.c_str(), O_WRONLY | O_CREAT, 0600);
    pid_t child;
    const int error =
        posix_spawnp(&child, words[0].c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (error) throw std::runtime_error(fmt::format("cannot run {}", words[0]));
    int status = 0;
    waitpid(child, &status, 0);
    if (status == 0) return;
    std::ifstream stream(messages);
    std::string message((std::istreambuf_iterator<char>(stream)), {});
    throw std::runtime_error(
        fmt::format("{} refuses the translation: {}", words[0], message.substr(0, 1000)));
}

}  // namespace

SharedObject::SharedObject(const std::string& source, const Compilation& compilation) {
    const ScratchFolder folder;
    const fs::path file = folder / "translation.cpp", object = folder / "translation.so";
    std::ofstream stream(file);
    stream << source;
    stream.close();
    if (!stream) throw std::runtime_error(fmt::format("cannot write {}", file.string()));
    compile(file, object, folder / "messages", compilation);
    handle_ = dlopen(object.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!handle_) throw std::runtime_error(fmt::format("cannot load a translation: {}", dlerror()));
}

SharedObject::~SharedObject() { dlclose(handle_); }

void* SharedObject::symbol(const char* name) const {
    void* const found = dlsym(handle_, name);
    if (!found) throw std::runtime_error(fmt::format("a translation lacks {}", name));
    return found;
}

CompiledFunction::CompiledFunction(const simulator::Elf& elf, std::string_view symbol,
                                   const Interface& interface, const Compilation& compilation)
    : symbol_(symbol),
      begin_(elf.function(symbol).address),
      end_(begin_ + elf.function(symbol).size),
      interface_(interface),
      flow_(control_flow(elf, symbol)),
      translation_(translate(elf, symbol, interface)),
      flash_(elf.flash()),
      object_(translation_.source, compilation),
      run_(reinterpret_cast<Run*>(object_.symbol("instructions_run"))) {
    flash_.resize(0x10000, 0xff);  // whatever address Z contains
}

CompiledFunction::Session::Session(const CompiledFunction& function)
    : function_(function),
      memory_(simulator::Chip::ram_end),
      covered_(function.translation_.leaders.size()) {}

void CompiledFunction::Session::run(std::span<const std::int64_t> operands,
                                    std::span<std::int64_t> results,
                                    std::span<std::uint32_t> cycles) {
    const char* what = nullptr;
    unsigned where = 0;
    const std::size_t done = function_.run_(
        operands.data(), cycles.size(), results.data(), cycles.data(), memory_.data(),
        function_.flash_.data(), covered_.data(), ++pattern_ * 0x9e3779b97f4a7c15, &what, &where);
    if (done == cycles.size()) return;
    const std::size_t arity = function_.arity();
    throw Misbehaviour(fmt::format("{} {} 0x{:x}, for the operands {}", function_.symbol_, what,
                                   where, fmt::join(operands.subspan(done * arity, arity), " ")));
}

std::vector<std::uint32_t> CompiledFunction::Session::reached_blocks() const {
    std::vector<std::uint32_t> blocks;
    for (std::size_t i = 0; i < covered_.size(); ++i)
        if (covered_[i]) blocks.push_back(function_.translation_.leaders[i]);
    return blocks;
}

std::vector<std::uint32_t> CompiledFunction::unreached(
    const std::set<std::uint32_t>& reached_blocks) const {
    std::set<std::uint32_t> met, reached;
    for (const Instruction& instruction : flow_.instructions) met.insert(instruction.address);
    for (std::uint32_t address : reached_blocks) {
        do {
            reached.insert(address);
            address = decode(flash_, address).next();
        } while (met.contains(address) && !flow_.leaders.contains(address));
    }
    std::vector<std::uint32_t> unreached;
    for (std::uint32_t address = begin_; address < end_; address = decode(flash_, address).next())
        if (!reached.contains(address)) unreached.push_back(address);
    return unreached;
}

}  // namespace instructions
