// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/experiments/scenes/any_program.hpp"

#include <fmt/format.h>

#include <cctype>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/experiments/scenes/chip_run.hpp"
#include "bench/lab/program/build.hpp"
#include "bench/lab/program/run.hpp"
#include "bench/lab/program/scratch.hpp"
#include "bench/lab/records/whole_file.hpp"
#include "this_build.hpp"

namespace scene_bench {
namespace {

namespace fs = std::filesystem;

const fs::path kernels = build_folder() / "kernels.a";

// The arguments of a command that CMake joined.
std::vector<std::string> split(std::string_view text) {
    std::vector<std::string> words;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('|', begin), text.size());
        words.emplace_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return words;
}

// "DoublePendulum" for "double_pendulum".
std::string type_of(std::string_view scene) {
    std::string type;
    bool first = true;
    for (const char letter : scene) {
        if (letter != '_')
            type += first ? static_cast<char>(std::toupper(static_cast<unsigned char>(letter)))
                          : letter;
        first = letter == '_';
    }
    return type;
}

const std::map<std::string_view, const char*> types_of_methods = {
    {"explicit_euler", "Published"},
    {"semi_implicit_euler", "SemiImplicit"},
    {"semi_implicit_compensated", "Compensated<scenes::SemiImplicit>"},
    {"velocity_verlet", "Verlet"},
    {"implicit_springs", "Implicit"},
    {"direct_rods", "Direct"}};

std::string type_of_scalar(std::string_view scalar) {
    const Layout layout = layout_of(scalar);
    return layout.fraction_bits < 0
               ? "float"
               : fmt::format("fixedpoint::Fixed<{},{}>", 8 * layout.bytes - layout.fraction_bits,
                             layout.fraction_bits);
}

// Whether the program is newer than every file in the compiler's list of its dependencies.
bool up_to_date(const fs::path& program, const fs::path& list) {
    std::ifstream stream(list);
    if (!fs::exists(program) || !stream) return false;
    const auto made = fs::last_write_time(program);
    if (fs::last_write_time(kernels) > made) return false;
    std::string word;
    stream >> word;  // the name of the target
    while (stream >> word)
        if (word != "\\" && (!fs::exists(word) || fs::last_write_time(word) > made)) return false;
    return true;
}

void copy_whole(const fs::path& from, const fs::path& to) {
    std::ifstream stream(from, std::ios::binary);
    records::write_whole(to, std::string(std::istreambuf_iterator<char>(stream), {}));
}

void run_compiler(const std::vector<std::string>& command, std::string_view what) {
    const fixbench::Ran ran = fixbench::run(command);
    if (ran.succeeded) return;
    if (ran.err.find("will not fit in region") != ran.err.npos) throw TooLarge("exceeds the flash");
    const std::size_t error = ran.err.find("error: ");
    throw std::runtime_error(fmt::format(
        "{} does not compile: {}", what,
        error == ran.err.npos ? ran.err.substr(0, ran.err.find('\n'))
                              : ran.err.substr(error, ran.err.find('\n', error) - error)));
}

}  // namespace

fs::path any_program(std::string_view scene, std::string_view scalar, std::string_view method,
                     int exponent) {
    const fs::path built = scene_programs(), folder = built.parent_path() / "programs_on_demand";
    fs::create_directories(folder);
    const fs::path program = program_path(folder, scene, scalar, method, std::to_string(exponent));
    const fs::path list = fs::path(program).replace_extension(".d");
    if (up_to_date(program, list)) return program;

    // Another process may make or run the same program meanwhile.
    const fixbench::Scratch scratch;
    const fs::path object = scratch.folder() / "object.o", linked = scratch.folder() / "linked.elf",
                   read = scratch.folder() / "read.d";
    const std::string what = program.stem().string();
    std::vector<std::string> compile = split(SCENE_COMPILE);
    compile.insert(compile.end(),
                   {"-DSCENE=" + type_of(scene), "-DSCALAR=" + type_of_scalar(scalar),
                    fmt::format("-DMETHOD={}", types_of_methods.at(method)), "-MMD", "-MF", read,
                    "-o", object});
    run_compiler(compile, what);
    std::vector<std::string> link = split(SCENE_LINK);
    link.insert(link.end(), {fmt::format("-Wl,--undefined=step_{}", exponent), object, kernels,
                             "-lm", "-o", linked});
    run_compiler(link, what);
    // The flash of an empty program, which is expected next to the program, is subtracted.
    fixbench::build({(built / "empty.elf").string()});
    copy_whole(built / "empty.elf", folder / "empty.elf");
    copy_whole(read, list);
    copy_whole(linked, program);
    return program;
}

}  // namespace scene_bench
