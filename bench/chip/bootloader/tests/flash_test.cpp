// SPDX-License-Identifier: GPL-3.0-or-later
// scripts/flash.sh with the avrdude that users have, through the bootloaders of real boards.
#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <numeric>
#include <span>

#include "bench/chip/bootloader/board.hpp"
#include "this_build.hpp"

namespace {

using bootloader::Board;
using simulator::Elf;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

const fs::path programs = build_folder() / "bench/chip/bootloader";
const fs::path application = programs / "bootloader_test_application.elf";

struct Outcome {
    int status;
    std::string output;  // including errors
};

class FlashTest : public testing::Test {
  protected:
    // A copy of the script with results, a build and devices that belong to the test.
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "flash_test.XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        project_ = name;
        for (const char* folder : {"scripts", "dev/serial/by-id", "results/data"})
            fs::create_directories(project_ / folder);
        fs::copy(source_folder() / "scripts/flash.sh", project_ / "scripts");
    }
    void TearDown() override { fs::remove_all(project_); }

    void plug_in(const Board& board, const std::string& name) {
        fs::create_symlink(board.port(), project_ / "dev" / name);
    }

    void write(const fs::path& path, const std::string& text) {
        fs::create_directories((project_ / path).parent_path());
        std::ofstream(project_ / path) << text;
    }

    // Runs the script and, at the same time, the board.
    Outcome flash(const std::string& arguments, Board* board = nullptr,
                  const char* path = nullptr) {
        const std::string command = fmt::format(
            "cd {0} && {1} FLASH_DEVICES={0}/dev /bin/bash scripts/flash.sh {2} 2>&1 </dev/null",
            project_.string(), path ? fmt::format("PATH={}", path) : "", arguments);
        std::FILE* const script = ::popen(command.c_str(), "re");
        if (!script) throw std::runtime_error("popen");
        ::fcntl(::fileno(script), F_SETFL, board ? O_NONBLOCK : 0);
        Outcome outcome;
        char text[4096];
        for (ssize_t count; (count = ::read(::fileno(script), text, sizeof text)) != 0;) {
            if (count > 0) outcome.output.append(text, count);
            if (board) board->serve();
        }
        const int status = ::pclose(script);
        outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
        return outcome;
    }

    // One line in addition to the announcement of what is written.
    static void expect_refusal(const Outcome& outcome, int status, const std::string& text) {
        EXPECT_EQ(outcome.status, status) << outcome.output;
        EXPECT_THAT(outcome.output, HasSubstr(text));
        const std::string& output = outcome.output;
        const std::size_t announcement = output.starts_with("flash.sh: writing") ? 1 : 0;
        EXPECT_EQ(std::ranges::count(output, '\n'), 1 + announcement) << output;
    }

    fs::path project_;
};

// What the application reports of the table in its flash.
std::string expected_greeting() {
    const std::vector<std::uint8_t> flash = Elf(application).flash();
    std::array<std::uint8_t, 256> beginning;
    std::iota(beginning.begin(), beginning.end(), 0);
    const auto table = std::ranges::search(flash, beginning).begin();
    std::uint16_t sum = 0;
    for (const std::uint8_t byte : std::span(table, 5001))
        sum = static_cast<std::uint16_t>(sum << 1 | sum >> 15) + byte;
    return fmt::format("application {:04x}\n", sum);
}

struct Nano {
    const char* bootloader;
    const char* option;
    std::uint32_t entry;
};

void PrintTo(const Nano& nano, std::ostream* out) { *out << nano.bootloader; }

class EachBootloader : public FlashTest, public testing::WithParamInterface<Nano> {
  protected:
    Board board_{programs / fmt::format("{}.elf", GetParam().bootloader), true};

    // The program, erased flash up to the bootloader, and the bootloader untouched.
    std::vector<std::uint8_t> expected_flash() const {
        std::vector<std::uint8_t> flash = Elf(application).flash();
        flash.resize(GetParam().entry, 0xff);
        const std::vector<std::uint8_t> bootloader =
            Elf(programs / fmt::format("{}.elf", GetParam().bootloader)).flash();
        flash.insert(flash.end(), bootloader.begin() + GetParam().entry, bootloader.end());
        flash.resize(Elf::flash_size, 0xff);
        return flash;
    }

    std::string arguments() const {
        return fmt::format("{} {}", GetParam().option, application.string());
    }
};

TEST_P(EachBootloader, WritesVerifiesAndStartsTheProgram) {
    ASSERT_EQ(board_.bootloader_entry(), GetParam().entry);
    plug_in(board_, "ttyUSB0");
    // The same device under another name is not another board.
    fs::create_symlink("../../ttyUSB0", project_ / "dev/serial/by-id/usb-1a86_USB_Serial-port0");
    const std::string hash = Elf(application).sha256();
    write("results/data/workload.csv", "quantity,elf_sha256\nloop rate," + hash + "\n");

    const Outcome outcome = flash(arguments(), &board_);
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr("flashed and verified"));
    EXPECT_THAT(outcome.output, HasSubstr("sha256 " + hash));
    EXPECT_THAT(outcome.output, HasSubstr("figures of this program: results/data/workload.csv"));
    EXPECT_TRUE(board_.flash() == expected_flash());

    for (int slice = 0; slice < 2000 && !board_.sent_by_application().ends_with('\n'); ++slice)
        board_.serve();
    EXPECT_EQ(board_.sent_by_application(), expected_greeting());
}

TEST_P(EachBootloader, AStuckBitIsDetected) {
    const std::string port = "--port " + board_.port() + " ";
    constexpr std::uint16_t address = 0x0a31;
    const std::uint8_t written = Elf(application).flash()[address];
    board_.set_stuck_bit(bootloader::StuckBit{address, 0x10, !(written & 0x10)});
    expect_refusal(flash(port + arguments(), &board_), 5, "0x0a31");

    // It was only this bit; and a board that failed once can be flashed again.
    std::vector<std::uint8_t> flash_with_the_bit = expected_flash();
    flash_with_the_bit[address] ^= 0x10;
    EXPECT_TRUE(board_.flash() == flash_with_the_bit);
    board_.set_stuck_bit(std::nullopt);
    EXPECT_EQ(flash(port + arguments(), &board_).status, 0);
    EXPECT_TRUE(board_.flash() == expected_flash());
}

INSTANTIATE_TEST_SUITE_P(, EachBootloader,
                         testing::Values(Nano{"optiboot", "", 0x7e00},
                                         Nano{"atmegaboot", "--old-bootloader", 0x7800}),
                         [](const auto& nano) { return nano.param.bootloader; });

TEST_F(FlashTest, TheOtherSpeedIsSuggested) {
    Board board(programs / "atmegaboot.elf", true);
    plug_in(board, "ttyUSB0");
    expect_refusal(flash(application, &board), 4, "try --old-bootloader");
    EXPECT_TRUE(board.flash()[0] == 0xff) << "something was written";
}

TEST_F(FlashTest, AnotherChipIsRefused) {
    Board board(programs / "optiboot_atmega168.elf", true);
    plug_in(board, "ttyACM0");
    expect_refusal(flash(application, &board), 4, "wrong board");
    EXPECT_TRUE(board.flash()[0] == 0xff) << "something was written";
}

TEST_F(FlashTest, PortsThatCannotBeUsedAreNamed) {
    expect_refusal(flash(application), 3, "no board");
    Board first(programs / "optiboot.elf", true), second(programs / "optiboot.elf", true);
    plug_in(first, "ttyUSB0");
    plug_in(second, "ttyACM0");
    const Outcome several = flash(application);
    expect_refusal(several, 3, "several boards");
    EXPECT_THAT(several.output, AllOf(HasSubstr("dev/ttyUSB0"), HasSubstr("dev/ttyACM0")));
    expect_refusal(flash("--port /dev/ttyNONE " + application.string()), 3, "no port /dev/ttyNONE");
    write("file", "");
    expect_refusal(flash("--port file " + application.string()), 3, "not a serial port");

    const int monitor = ::open(first.port().c_str(), O_RDWR | O_NOCTTY | O_CLOEXEC);
    const Outcome busy = flash("--port dev/ttyUSB0 " + application.string(), &first);
    expect_refusal(busy, 3, fmt::format("process {}; close it", ::getpid()));
    ::close(monitor);
}

TEST_F(FlashTest, ProgramsThatCannotBeWrittenAreNamed) {
    expect_refusal(flash(""), 2, "scripts/build.sh builds it");
    expect_refusal(flash("absent.elf"), 2, "no program 'absent.elf'");
    write("text.elf", "not an ELF");
    expect_refusal(flash("text.elf"), 2, "not a linked program for the AVR");
    expect_refusal(flash("/bin/true"), 2, "not a linked program for the AVR");
    expect_refusal(flash("--frobnicate"), 2, "--frobnicate");
    expect_refusal(flash("--port"), 2, "--port needs");
    expect_refusal(flash("one.elf two.elf"), 2, "one program at a time");

    // 30,800 bytes: too many for the larger bootloader only; then for both.
    for (const auto& [bytes, option, limit] :
         {std::tuple{30800, "--old-bootloader ", "leaves 30720"}, {32300, "", "leaves 32256"}}) {
        write("large.S", fmt::format(".space {}\n", bytes));
        const std::string compile = fmt::format(
            "cd {} && avr-gcc -mmcu=atmega328p -nostdlib large.S -o large.elf", project_.string());
        ASSERT_EQ(std::system(compile.c_str()), 0);
        expect_refusal(flash(std::string(option) + "large.elf"), 2, limit);
        if (bytes == 30800) expect_refusal(flash("large.elf"), 3, "no board");
    }
}

TEST_F(FlashTest, AMissingToolIsNamedWithWhatInstallsIt) {
    fs::create_directory(project_ / "bin");
    for (const char* tool : {"sed", "dirname", "avr-objcopy", "avr-readelf", "sha256sum"})
        fs::create_symlink(fs::path("/usr/bin") / tool, project_ / "bin" / tool);
    expect_refusal(flash(application, nullptr, (project_ / "bin").c_str()), 6,
                   "avrdude is missing; scripts/setup.sh");
}

TEST_F(FlashTest, FiguresOfAnotherProgramAreNotUsed) {
    Board board(programs / "optiboot.elf", true);
    plug_in(board, "ttyUSB0");
    const std::string other(64, 'b');
    write("results/data/workload.csv", "quantity,elf_sha256\nloop rate," + other + "\n");
    const Outcome outcome = flash(application, &board);
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(
        outcome.output,
        HasSubstr("no measured figures of this program: results/data/workload.csv is about " +
                  other));
    EXPECT_THAT(outcome.output,
                Not(HasSubstr("measured figures of this program: results/data/w\n")));
}

}  // namespace
