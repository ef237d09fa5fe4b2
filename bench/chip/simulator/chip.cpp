// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/chip/simulator/chip.hpp"

#include <avr_extint.h>
#include <avr_ioport.h>
#include <fmt/format.h>
#include <sim_avr.h>
#include <sim_core.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <list>
#include <new>
#include <string>
#include <utility>

#include "bench/chip/simulator/hooks.hpp"
#include "bench/chip/simulator/registers.hpp"
#include "bench/chip/simulator/workarounds/adc.hpp"
#include "bench/chip/simulator/workarounds/interrupts.hpp"
#include "bench/chip/simulator/workarounds/timer1.hpp"
#include "bench/chip/simulator/workarounds/uart.hpp"
#include "bench/chip/simulator/workarounds/write_one.hpp"

namespace simulator {
namespace {

// simavr reports an access beyond RAM but executes it nevertheless; `lpm` and `spm` are not checked
// at all. A guest's addresses have 16 bits, so 64 KiB of host memory contain whatever it reaches
// before the run ends, at no cost in speed.
void widen(std::uint8_t*& memory, std::size_t size, std::uint8_t fill) {
    constexpr std::size_t address_space = 0x10000;
    auto* const wider = static_cast<std::uint8_t*>(std::realloc(memory, address_space));
    if (!wider) throw std::bad_alloc();
    memory = wider;
    std::memset(memory + size, fill, address_space - size);
}

avr_t* make_core() {
    avr_t* const avr = avr_make_mcu_by_name(std::string(Elf::device).c_str());
    if (!avr) throw SimulationError("libsimavr was built without the ATmega328P");
    avr_init(avr);
    widen(avr->data, Chip::ram_end, 0);
    widen(avr->flash, Elf::flash_size + 2, 0xff);  // with the word that stops the core
    avr->frequency = Chip::frequency;
    avr->vcc = avr->avcc = avr->aref = 1000 * Adc::supply;  // millivolts; simavr's default is 3300
    return avr;
}

avr_irq_t* pin_signal(avr_t* avr, Pin pin) {
    avr_irq_t* const signal = avr_io_getirq(avr, AVR_IOCTL_IOPORT_GETIRQ(pin.port), pin.bit);
    if (!signal || pin.bit < 0 || pin.bit > 7)
        throw SimulationError(fmt::format("no pin P{}{} on the ATmega328P", pin.port, pin.bit));
    return signal;
}

bool is_out(std::uint16_t opcode) { return (opcode & 0xf800) == 0xb800; }

}  // namespace

struct Chip::Attachments {
    explicit Attachments(Chip& chip)
        : write_one(chip.avr_),
          timer1(chip.avr_),
          uart(chip.avr_),
          adc(chip.avr_),
          // The core stores the stack pointer as two bytes, low byte first, at each push, pop, call
          // and return. A program stores it with two `out`, in avr-gcc's code the high byte first.
          // So the pair is complete after the high byte, unless an `out` wrote it.
          stack_low(chip.avr_, registers::spl,
                    [&chip](const WriteHook& hook, std::uint8_t value) {
                        hook.forward(value);
                        if (is_out(current_opcode(chip.avr_))) chip.note_stack_pointer();
                    }),
          stack_high(chip.avr_, registers::sph,
                     [&chip](const WriteHook& hook, std::uint8_t value) {
                         hook.forward(value);
                         if (!is_out(current_opcode(chip.avr_))) chip.note_stack_pointer();
                     }),
          // EEARH holds two bits; simavr uses an address made of all eight.
          eeprom_high(chip.avr_, registers::eearh,
                      [](const WriteHook& hook, std::uint8_t value) { hook.forward(value & 3); }),
          gpior0(chip.avr_, registers::gpior0,
                 [&chip, this](const WriteHook& hook, std::uint8_t value) {
                     hook.forward(value);
                     if (at_gpior0) at_gpior0(chip.cycle(), value);
                 }) {}

    WriteOneRegisters write_one;
    Timer1Compare timer1;
    Uart uart;
    Adc adc;
    WriteHook stack_low, stack_high, eeprom_high, gpior0;
    WriteCallback at_gpior0;
    std::list<SignalHook> edges;
};

Chip::Chip(Elf elf)
    : elf_(std::move(elf)),
      avr_(make_core()),
      data_(avr_->data),
      attachments_(std::make_unique<Attachments>(*this)) {
    avr_->custom.data = this;
    avr_global_logger_set(on_message);
    std::copy(elf_.flash().begin(), elf_.flash().end(), avr_->flash);
    reset();
}

Chip::~Chip() {
    // Not freed by avr_terminate(): the signals of interrupts and registers, and their list.
    for (int i = 0; i < avr_->interrupts.vector_count; ++i)
        avr_free_irq(avr_->interrupts.vector[i]->irq, AVR_INT_IRQ_COUNT);
    avr_free_irq(avr_->interrupts.irq, AVR_INT_IRQ_COUNT);
    for (auto& io_register : avr_->io) avr_free_irq(io_register.irq, AVR_IOMEM_IRQ_ALL + 1);
    avr_terminate(avr_);
    std::free(static_cast<void*>(avr_->irq_pool.irq));
    std::free(avr_);
}

void Chip::reset() {
    avr_reset(avr_);
    avr_->cycle = 0;
    attachments_->uart.reset();
    attachments_->adc.reset();
    // simavr looks each cycle at an INT0 or INT1 pin that is low, as long as the interrupt senses
    // the level, which is its setting after reset; that makes a run four times slower.
    for (const int pin : {EXTINT_IRQ_OUT_INT0, EXTINT_IRQ_OUT_INT1})
        avr_extint_set_strict_lvl_trig(avr_, pin, 0);
    failure_.clear();
    data_end_ = static_cast<std::uint16_t>(elf_.object("_end").address);
    forget_lowest_stack_pointer();
}

void Chip::note_stack_pointer() {
    const std::uint16_t pointer = stack_pointer();
    if (pointer >= lowest_stack_pointer_) return;
    lowest_stack_pointer_ = pointer;
    if (pointer + 1 < data_end_)
        fail(fmt::format("the stack ran into the data: stack pointer 0x{:04x}, data up to 0x{:04x}",
                         pointer, data_end_ - 1));
}

std::uint16_t Chip::allocate(std::uint16_t bytes) {
    if (data_end_ + bytes > stack_pointer())
        throw SimulationError(
            fmt::format("no {} bytes of SRAM free above 0x{:04x}", bytes, data_end_));
    return std::exchange(data_end_, static_cast<std::uint16_t>(data_end_ + bytes));
}

void Chip::fail(const std::string& reason) {
    if (avr_->state != cpu_Crashed)
        failure_ = fmt::format("{} at {}, cycle {}", reason, elf_.describe(avr_->pc), avr_->cycle);
    avr_->state = cpu_Crashed;
}

// simavr reports a fault only by a message; after an illegal opcode it even continues.
void Chip::on_message(avr_t* avr, int level, const char* format, va_list) {
    if (level != LOG_ERROR || !avr || !avr->custom.data) return;
    Chip& chip = *static_cast<Chip*>(avr->custom.data);
    if (avr->pc >= chip.elf_.flash().size())
        chip.fail("jump out of the program,");
    else if (std::strstr(format, "Invalid Opcode"))
        chip.fail(fmt::format("illegal opcode 0x{:04x}", current_opcode(avr)));
    else if (std::strstr(format, "Invalid write address") ||
             std::strstr(format, "Invalid read address"))
        chip.fail("access to a data address beyond the RAM");
}

// Replaces avr_run(), which paces a sleep to the wall clock and overshoots its end by a cycle.
void Chip::advance(Cycle most) {
    avr_->run_cycle_limit = most;
    const Cycle until_event = avr_cycle_timer_process(avr_);  // also sets how long a burst may be
    if (avr_->state == cpu_Sleeping)
        avr_->cycle += std::min(until_event, most);
    else
        avr_->pc = avr_run_one(avr_);
    throw_if_crashed();
    const bool asleep = avr_->state == cpu_Sleeping;
    avr_cycle_timer_process(avr_);
    service_interrupts(avr_, asleep);
}

void Chip::step() {
    constexpr Cycle longest_sleep = 1000;
    advance(avr_->state == cpu_Sleeping ? longest_sleep : 1);
}

void Chip::run_until_cycle(Cycle cycle) {
    while (avr_->cycle < cycle) advance(cycle - avr_->cycle);
}

void Chip::run_until_address(std::uint32_t flash_address, Cycle budget) {
    run_until([&] { return avr_->pc == flash_address; }, budget);
}

void Chip::run_until_function(std::string_view name, Cycle budget) {
    run_until_address(elf_.function(name).address, budget);
}

Cycle Chip::cycle() const { return avr_->cycle; }
std::uint32_t Chip::program_counter() const { return avr_->pc; }
void Chip::set_program_counter(std::uint32_t flash_address) { avr_->pc = flash_address; }

std::uint8_t Chip::status() const {
    std::uint8_t bits = 0;
    for (int i = 0; i < 8; ++i) bits |= avr_->sreg[i] << i;
    return bits;
}

void Chip::expect_in_data_space(std::uint16_t address, std::size_t bytes) const {
    if (address + bytes > ram_end)
        throw SimulationError(
            fmt::format("{} bytes at data address 0x{:04x} reach beyond the RAM", bytes, address));
}

void Chip::read(std::uint16_t address, std::span<std::uint8_t> bytes) const {
    expect_in_data_space(address, bytes.size());
    std::copy_n(data_ + address, bytes.size(), bytes.begin());
}

void Chip::write(std::uint16_t address, std::span<const std::uint8_t> bytes) {
    expect_in_data_space(address, bytes.size());
    std::copy(bytes.begin(), bytes.end(), data_ + address);
}

void Chip::on_gpior0_write(WriteCallback callback) {
    attachments_->at_gpior0 = std::move(callback);
}
void Chip::on_conversion(VoltageCallback volts) {
    attachments_->adc.on_conversion(std::move(volts));
}
void Chip::on_uart_byte(WriteCallback callback) { attachments_->uart.on_sent(std::move(callback)); }
void Chip::send_to_uart(std::uint8_t byte) { attachments_->uart.receive(byte); }
void Chip::set_pin(Pin pin, bool level) { avr_raise_irq(pin_signal(avr_, pin), level); }

void Chip::on_edge(Pin pin, EdgeCallback callback) {
    avr_irq_t* const signal = pin_signal(avr_, pin);
    attachments_->edges.emplace_back(
        signal, [this, callback = std::move(callback),
                 last = (signal->value & 1) != 0](std::uint32_t value) mutable {
            const bool level = value & 1;
            if (level != std::exchange(last, level)) callback(avr_->cycle, level);
        });
}

void Chip::throw_if_crashed() const {
    const auto where = [&] {
        return fmt::format(" at {}, cycle {}", elf_.describe(avr_->pc), avr_->cycle);
    };
    if (avr_->state == cpu_Crashed) throw SimulationError(failure_);
    if (avr_->pc >= elf_.flash().size())
        throw SimulationError("jump out of the program," + where());
    if (avr_->state == cpu_Sleeping && !avr_->sreg[S_I])
        throw SimulationError("sleep with interrupts off, which nothing ends," + where());
}

void Chip::throw_budget_exceeded(Cycle budget) const {
    throw SimulationError(
        fmt::format("not done after {} cycles, at {}", budget, elf_.describe(avr_->pc)));
}

}  // namespace simulator
