// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/bootloader/board.hpp"

#include <asm/termbits.h>  // termios2, where speeds are numbers; excludes <termios.h>
#include <fcntl.h>
#include <poll.h>
#include <sim_avr.h>
#include <stdlib.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <system_error>
#include <thread>

#include "bench/chip/simulator/registers.hpp"

namespace bootloader {
namespace {

using namespace std::chrono_literals;
using simulator::Chip;
using simulator::Cycle;
namespace registers = simulator::registers;

constexpr std::uint16_t mcusr = 0x54;
constexpr std::uint8_t external_reset = 0x02;  // bit EXTRF of MCUSR

constexpr auto longest_wait = 1ms;
constexpr Cycle longest_run = Chip::frequency / 500;  // simulated time per call
constexpr Cycle patience = Chip::frequency / 2;
constexpr double speed_tolerance = 0.04;  // of an asynchronous receiver of ten bits

int checked(int result, const char* what) {
    if (result < 0) throw std::system_error(errno, std::generic_category(), what);
    return result;
}

std::chrono::nanoseconds duration(Cycle cycles) {
    return std::chrono::nanoseconds(cycles * 1000 / (Chip::frequency / 1'000'000));
}

Cycle cycles_in(std::chrono::nanoseconds time) {
    return time.count() * (Chip::frequency / 1'000'000) / 1000;
}

}  // namespace

Descriptor::~Descriptor() { ::close(number_); }

Board::Board(const std::filesystem::path& bootloader, bool patient)
    : chip_(simulator::Elf(bootloader)),
      entry_(chip_.elf().function("bootloader").address),
      terminal_(
          checked(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC), "a pseudo-terminal")),
      patient_(patient) {
    checked(::grantpt(terminal_), "a pseudo-terminal");
    checked(::unlockpt(terminal_), "a pseudo-terminal");
    char name[128];
    if (const int error = ::ptsname_r(terminal_, name, sizeof name))
        throw std::system_error(error, std::generic_category(), "a pseudo-terminal");
    port_ = name;

    // A terminal that nobody has opened yet does not count as closed, so it is opened once. Like a
    // serial line, it neither echoes nor translates.
    const Descriptor other_end(checked(::open(name, O_RDWR | O_NOCTTY | O_CLOEXEC), name));
    termios2 settings{};
    settings.c_cflag = CS8 | CREAD | CLOCAL | B9600;
    checked(::ioctl(other_end, TCSETS2, &settings), name);

    chip_.on_uart_byte([this](Cycle cycle, std::uint8_t byte) {
        last_byte_ = cycle;
        sent_.push_back(byte);
    });
}

void Board::press_reset(std::uint8_t cause) {
    chip_.reset();
    if (cause) chip_.write(mcusr, {&cause, 1});
    chip_.set_program_counter(entry_);  // as the fuse BOOTRST does
    held_in_reset_ = false;
    last_byte_ = 0;
    start_ = Clock::now();
    sent_by_application_.clear();
}

void Board::watch_port() {
    pollfd terminal{terminal_, POLLIN, 0};
    // poll() returns immediately for a closed port: wait elsewhere.
    if (!open_) std::this_thread::sleep_for(longest_wait);
    ::poll(&terminal, 1, open_ ? static_cast<int>(longest_wait / 1ms) : 0);
    const bool open = !(terminal.revents & POLLHUP);
    if (open && !open_) press_reset(external_reset);
    open_ = open;
}

bool Board::same_speed() const {
    termios2 settings{};
    if (::ioctl(terminal_, TCGETS2, &settings) < 0) return false;
    const std::uint8_t* const data = chip_.data();
    const int divider = 1 + (data[registers::ubrr0l] | (data[registers::ubrr0h] & 0x0f) << 8);
    const double speed = Chip::frequency / (data[registers::ucsr0a] & 2 ? 8. : 16.) / divider;
    return std::abs(speed / settings.c_ospeed - 1) < speed_tolerance;
}

// Bytes sent at another speed than the chip's are lost.
void Board::receive() {
    std::uint8_t bytes[256];
    for (ssize_t count; (count = ::read(terminal_, bytes, sizeof bytes)) > 0;) {
        if (!same_speed()) continue;
        for (const std::uint8_t byte : std::span(bytes, count)) chip_.send_to_uart(byte);
        last_byte_ = chip_.cycle();
    }
}

void Board::send() {
    if (!in_bootloader()) sent_by_application_.append(sent_.begin(), sent_.end());
    if (open_ && same_speed()) {
        // A full buffer loses bytes, like the adapter's.
        [[maybe_unused]] const auto written = ::write(terminal_, sent_.data(), sent_.size());
    }
    sent_.clear();
}

bool Board::host_is_late() const {
    return patient_ && open_ && in_bootloader() && chip_.cycle() > last_byte_ + patience;
}

void Board::run(Cycle until) {
    const auto run_as_before = chip_.core()->run;
    chip_.run_until_cycle(until);
    // A watchdog that expired replaces simavr's run function by one that resets.
    if (chip_.core()->run != run_as_before) press_reset(0);
    if (stuck_bit_) {
        std::uint8_t& byte = chip_.core()->flash[stuck_bit_->address];
        byte = stuck_bit_->level ? byte | stuck_bit_->mask : byte & ~stuck_bit_->mask;
    }
}

void Board::serve() {
    watch_port();
    receive();
    if (held_in_reset_) return;
    const auto now = Clock::now();
    const Cycle cycle = chip_.cycle();
    const Cycle most = host_is_late() ? cycle : cycle + longest_run;
    start_ = std::max(start_, now - duration(most));
    const Cycle until = cycles_in(now - start_);
    if (until <= cycle) return;
    run(until);
    send();
}

std::vector<std::uint8_t> Board::flash() const {
    const std::uint8_t* const flash = chip_.core()->flash;
    return {flash, flash + simulator::Elf::flash_size};
}

}  // namespace bootloader
