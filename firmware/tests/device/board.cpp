// SPDX-License-Identifier: MIT
// Exercises the whole board together; the test controls it through variables.
#include <firmware/hardware/atmega328p.hpp>

namespace {

struct Chosen : firmware::Configuration {
    static constexpr uint16_t servo_shortest = 600;
    static constexpr uint16_t servo_longest = 2400;
    static constexpr uint8_t readings_in_sum = 4;
};
using Board = firmware::Atmega328p<Chosen>;

}  // namespace

FIRMWARE_INTERRUPTS(Board)

extern "C" {
enum Task : uint8_t { rest, flood, echo, busy, watch_clock, alternate_pulses, deaf };
volatile uint8_t task;
volatile uint16_t pulse = 3000;
volatile uint16_t sums[firmware::inputs];
volatile uint32_t time;
volatile uint8_t lost;
volatile uint8_t went_backwards;
}

// The compiler must not move the reading of the clock out of the bracket.
extern "C" __attribute__((noinline)) uint32_t bracketed_ticks() {
    GPIOR0 = 1;
    const uint32_t now = Board::ticks();
    GPIOR0 = 2;
    return now;
}

static void write_flood() {
    static uint8_t next;
    char bytes[8];
    for (uint8_t i = 0; i < sizeof bytes; ++i) bytes[i] = next + i;
    next += Board::try_write(bytes, sizeof bytes);
}

static void write_echo() {
    while (Board::writable() != 0) {
        const int16_t byte = Board::read();
        if (byte < 0) return;
        const char character = byte;
        Board::try_write(&character, 1);
    }
}

// Reads its clock so often that some readings meet an overflow.
static void judge_clock() {
    static uint32_t last;
    const uint32_t now = bracketed_ticks();
    if (static_cast<int32_t>(now - last) <= 0) went_backwards = 1;
    last = now;
    time = now;
}

int main() {
    Board::start();
    for (;;) {
        const firmware::Readings readings = Board::readings();
        for (uint8_t i = 0; i < firmware::inputs; ++i) sums[i] = readings.sum[i];
        Board::command_servo(pulse);
        if (task == flood || task == busy) write_flood();
        if (task == echo || task == busy) write_echo();
        while (task == watch_clock) judge_clock();
        while (task == alternate_pulses) {
            Board::command_servo(2000);
            Board::command_servo(4000);
        }
        if (task == deaf) {
            cli();
            const uint16_t begin = TCNT1;
            while (TCNT1 - begin < 1000) {
            }
            sei();
            task = echo;
        }
        if (task == rest) {
            Board::try_write(nullptr, 0);
            Board::idle();
        }
        judge_clock();
        lost = Board::lost();
    }
}
