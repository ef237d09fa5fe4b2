// SPDX-License-Identifier: GPL-3.0-or-later
// A function of a device program as host code: translated, compiled, loaded. A call takes about ten
// nanoseconds, against a microsecond in the simulator.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/chip/instructions/translate.hpp"
#include "this_build.hpp"

namespace instructions {

// A call that broke the calling convention, accessed memory outside its areas, or did not return.
class Misbehaviour : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

// How the source is compiled.
struct Compilation {
    std::string options = "-O3 -march=native";
    std::filesystem::path include_folder = source_folder();  // contains bench/chip/instructions
};

// A shared object compiled from C++ source, unloaded by the destructor. Throws std::runtime_error
// if the compiler rejects the source.
class SharedObject {
  public:
    explicit SharedObject(const std::string& source, const Compilation& compilation = {});
    ~SharedObject();
    SharedObject(const SharedObject&) = delete;
    SharedObject& operator=(const SharedObject&) = delete;

    void* symbol(const char* name) const;

  private:
    void* handle_;
};

class CompiledFunction {
  public:
    // Throws TranslationError or std::runtime_error.
    CompiledFunction(const simulator::Elf& elf, std::string_view symbol, const Interface& interface,
                     const Compilation& compilation = {});

    const std::string& symbol() const { return symbol_; }
    std::size_t arity() const { return interface_.operands.size(); }
    std::size_t result_count() const { return interface_.results.size(); }
    // Every instruction that control flow can reach, including those of called functions.
    const ControlFlow& flow() const { return flow_; }

    // The state that each thread of a caller needs: memory, and which blocks were executed.
    class Session {
      public:
        explicit Session(const CompiledFunction& function);

        // Makes as many calls as `cycles` has elements; the raws of the calls follow one after the
        // other. Cycles include call (4) and ret (4). Throws Misbehaviour, which names the
        // operands.
        void run(std::span<const std::int64_t> operands, std::span<std::int64_t> results,
                 std::span<std::uint32_t> cycles);

        std::vector<std::uint32_t> reached_blocks() const;  // addresses of their first instructions

        // The data space, for a function that works on the program's variables.
        std::span<std::uint8_t> memory() { return memory_; }

      private:
        const CompiledFunction& function_;
        std::vector<std::uint8_t> memory_, covered_;
        std::uint64_t pattern_ = 0;
    };

    // The instructions among the symbol's own bytes that are in none of the given blocks, sorted.
    std::vector<std::uint32_t> unreached(const std::set<std::uint32_t>& reached_blocks) const;

  private:
    using Run = std::size_t(const std::int64_t* operands, std::size_t count, std::int64_t* results,
                            std::uint32_t* cycles, std::uint8_t* memory, const std::uint8_t* flash,
                            std::uint8_t* covered, std::uint64_t pattern, const char** what,
                            unsigned* where);

    std::string symbol_;
    std::uint32_t begin_, end_;
    Interface interface_;
    ControlFlow flow_;
    Translation translation_;
    std::vector<std::uint8_t> flash_;
    SharedObject object_;
    Run* run_;
};

}  // namespace instructions
