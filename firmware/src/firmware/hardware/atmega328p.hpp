// SPDX-License-Identifier: MIT
/// \file
/// The ATmega328P at 16 MHz: analogue inputs, serial port, servo, clock and profiling pins.
/// Everything runs in interrupts; only idle() waits for the hardware. A program has one Board, and
/// its main file says FIRMWARE_INTERRUPTS(Board) outside every namespace.
///
/// All 16 bits of Timer1 count half microseconds: its overflows make the clock, its compare unit A
/// the edges of the servo's pulse.
#pragma once

#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include <util/atomic.h>

#include <firmware/configuration.hpp>
#include <firmware/hardware/readings.hpp>
#include <firmware/hardware/ring_buffer.hpp>

namespace firmware {

static_assert(F_CPU == 16000000, "The timings are those of a 16 MHz clock.");

/// The board, configured by Chosen. Everything is static, since there is only one.
template <class Chosen>
class Atmega328p : CheckedConfiguration<Chosen> {
  public:
    /// The configuration.
    using Configuration = Chosen;

    /// Sets every register that matters, whatever a bootloader left in it, and enables interrupts.
    /// Must be called once, before anything else.
    static void start();

    /// The clock: half microseconds since start(), modulo 2^32. Right as long as interrupts are
    /// never disabled for 16 ms or more.
    static uint32_t ticks();

    /// The sum of the newest readings of each input.
    static Readings readings();

    /// Sets the servo's pulse from its next period on, in half microseconds. A pulse outside the
    /// servo's travel counts as the nearest end.
    static void command_servo(uint16_t pulse);

    /// The number of bytes that the serial port (250000 baud, 8N1) has room for.
    static uint8_t writable() { return transmit_.free(); }
    /// Sends as many bytes as there is room for and returns their number. Does not wait.
    static uint8_t try_write(const char* text, uint8_t length);
    /// Removes and returns the oldest received byte, or returns -1 if there is none.
    static int16_t read() { return receive_.empty() ? -1 : receive_.pop(); }
    /// The number of received bytes that were lost, because the buffer was full or they arrived
    /// damaged; stops at 255. All bytes lost in one overrun of the receiver itself count as one.
    static uint8_t lost() { return lost_; }

    /// Set the profiling pin of a category high or low; compiled to nothing if the category is not
    /// profiled.
    /// @{
    template <Category category>
    static void raise() {
        if (contains(Configuration::profiled, category))
            PORTD = static_cast<uint8_t>(PORTD | pin_of(category));
    }
    template <Category category>
    static void lower() {
        if (contains(Configuration::profiled, category))
            PORTD = static_cast<uint8_t>(PORTD & ~pin_of(category));
    }
    /// @}

    /// Sleeps until the next interrupt, at most the 0.1 ms of a conversion.
    static void idle() { sleep_mode(); }

    /// Called by FIRMWARE_INTERRUPTS.
    /// @{
    static inline void conversion_complete() __attribute__((always_inline));
    static inline void servo_edge_is_near() __attribute__((always_inline));
    static inline void clock_overflow() __attribute__((always_inline)) {
        overflows_ = overflows_ + 1;
    }
    static inline void transmitter_ready() __attribute__((always_inline));
    static inline void byte_received() __attribute__((always_inline));
    /// @}

  private:
    static constexpr uint8_t servo_pin = 1 << PD7;
    static constexpr uint8_t pin_of(Category category) {
        return static_cast<uint8_t>(1 << (PD2 + static_cast<uint8_t>(category)));
    }
    static constexpr uint8_t profiling_pins = static_cast<uint8_t>(Configuration::profiled << PD2);

    // The supply is the reference, as it is for the dividers.
    static constexpr uint8_t multiplexer(uint8_t input) {
        return 1 << REFS0 | (input == sensor_a   ? Configuration::sensor_a_input
                             : input == sensor_b ? Configuration::sensor_b_input
                                                 : Configuration::dial_input);
    }
    // 125 kHz, the converter's fastest clock that keeps all ten bits.
    static constexpr uint8_t start_conversion =
        1 << ADEN | 1 << ADSC | 1 << ADIE | 1 << ADPS2 | 1 << ADPS1 | 1 << ADPS0;

    static constexpr uint8_t receiver_on = 1 << RXEN0 | 1 << TXEN0 | 1 << RXCIE0;
    static constexpr uint8_t transmitter_on = receiver_on | 1 << UDRIE0;

    static constexpr uint16_t servo_period = 20 * ticks_per_millisecond;
    // How much earlier than an edge its interrupt comes. Covers its own entry and the longest delay
    // by another interrupt or an atomic block.
    static constexpr uint8_t servo_lead = 12 * ticks_per_microsecond;

    // The newest readings; those of input i are at i, i + inputs and so on.
    static constexpr uint8_t places = inputs * Configuration::readings_in_sum;
    static volatile uint16_t history_[places];
    static volatile uint8_t place_;  // of the next reading
    static volatile uint16_t overflows_;
    static uint16_t pulse_, rise_, edge_;
    static RingBuffer<Configuration::transmit_capacity> transmit_;
    static RingBuffer<Configuration::receive_capacity> receive_;
    static volatile uint8_t lost_;
};

template <class C>
volatile uint16_t Atmega328p<C>::history_[places];
template <class C>
volatile uint8_t Atmega328p<C>::place_;
template <class C>
volatile uint16_t Atmega328p<C>::overflows_;
template <class C>
uint16_t Atmega328p<C>::pulse_;
template <class C>
uint16_t Atmega328p<C>::rise_;
template <class C>
uint16_t Atmega328p<C>::edge_;
template <class C>
RingBuffer<C::transmit_capacity> Atmega328p<C>::transmit_;
template <class C>
RingBuffer<C::receive_capacity> Atmega328p<C>::receive_;
template <class C>
volatile uint8_t Atmega328p<C>::lost_;

template <class C>
void Atmega328p<C>::start() {
    PORTD &= static_cast<uint8_t>(~(servo_pin | profiling_pins));
    DDRD |= servo_pin | profiling_pins;

    pulse_ = C::servo_at_start * ticks_per_microsecond;
    rise_ = edge_ = ticks_per_millisecond;
    TCCR1B = 0;  // stopped
    TCCR1A = 0;
    TCNT1 = 0;
    OCR1A = edge_ - servo_lead;
    TIFR1 = 1 << OCF1A | 1 << TOV1;
    TIMSK1 = 1 << OCIE1A | 1 << TOIE1;
    TCCR1B = 1 << CS11;  // 2 MHz

    UCSR0A = 0;
    UCSR0C = 1 << UCSZ01 | 1 << UCSZ00;
    UBRR0 = 3;  // 16 * (3 + 1) cycles a bit
    UCSR0B = receiver_on;

    DIDR0 = (1 << C::sensor_a_input | 1 << C::sensor_b_input | 1 << C::dial_input) & 0x3f;
    ADCSRB = 0;
    ADMUX = multiplexer(sensor_a);
    ADCSRA = start_conversion;

    SMCR = static_cast<uint8_t>(SMCR & ~(1 << SM0 | 1 << SM1 | 1 << SM2));  // idle
    sei();
}

template <class C>
uint32_t Atmega328p<C>::ticks() {
    uint16_t high, low;
    ATOMIC_BLOCK(ATOMIC_RESTORESTATE) {
        low = TCNT1;
        high = overflows_;
        // An overflow whose interrupt is still pending happened before the count was read if the
        // count is low.
        if ((TIFR1 & 1 << TOV1) != 0 && low < 0x8000) ++high;
    }
    return static_cast<uint32_t>(high) << 16 | low;
}

// Reads again if a reading arrived in between. That happens at most once: the next is 0.1 ms away.
template <class C>
Readings Atmega328p<C>::readings() {
    Readings result;
    uint8_t place;
    do {
        place = place_;
        result = Readings();
        for (uint8_t i = 0; i < places; i = static_cast<uint8_t>(i + inputs))
            for (uint8_t input = 0; input < inputs; ++input)
                result.sum[input] += history_[i + input];
    } while (place != place_);
    return result;
}

template <class C>
void Atmega328p<C>::command_servo(uint16_t pulse) {
    pulse = servo_pulse<C>(pulse);
    ATOMIC_BLOCK(ATOMIC_RESTORESTATE) { pulse_ = pulse; }
}

template <class C>
uint8_t Atmega328p<C>::try_write(const char* text, uint8_t length) {
    const uint8_t room = transmit_.free();
    const uint8_t taken = length < room ? length : room;
    for (uint8_t i = 0; i < taken; ++i) transmit_.push(text[i]);
    // The interrupt turns itself off with the last byte: test and write must not be separated.
    ATOMIC_BLOCK(ATOMIC_RESTORESTATE) {
        if (!transmit_.empty()) UCSR0B = transmitter_on;
    }
    return taken;
}

// Starts the next conversion first, so that nothing delays it.
template <class C>
void Atmega328p<C>::conversion_complete() {
    const uint16_t reading = ADC;
    const uint8_t selected = ADMUX;
    ADMUX = selected == multiplexer(sensor_a)   ? multiplexer(sensor_b)
            : selected == multiplexer(sensor_b) ? multiplexer(dial)
                                                : multiplexer(sensor_a);
    ADCSRA = start_conversion;
    const uint8_t place = place_;
    history_[place] = reading;
    place_ = static_cast<uint8_t>(place == places - 1 ? 0 : place + 1);
}

// Waits for the exact tick of the edge, so that neither other interrupts nor atomic blocks move it.
// The length of a pulse is fixed when it starts.
template <class C>
void Atmega328p<C>::servo_edge_is_near() {
    const uint8_t edge = static_cast<uint8_t>(edge_);
    while (static_cast<int8_t>(TCNT1L - edge) < 0) {
    }
    PIND = servo_pin;  // toggles
    const bool rising = (PORTD & servo_pin) != 0;
    edge_ = rising ? rise_ + pulse_ : (rise_ += servo_period);
    OCR1A = edge_ - servo_lead;
}

template <class C>
void Atmega328p<C>::transmitter_ready() {
    UDR0 = transmit_.pop();
    if (transmit_.empty()) UCSR0B = receiver_on;
}

template <class C>
void Atmega328p<C>::byte_received() {
    const uint8_t status = UCSR0A;
    const uint8_t byte = UDR0;
    const bool kept = (status & 1 << FE0) == 0 && receive_.free() != 0;
    if (kept) receive_.push(byte);
    // An overrun means that bytes after this one were lost.
    if ((!kept || (status & 1 << DOR0) != 0) && lost_ != 255) {
        lost_ = static_cast<uint8_t>(lost_ + 1);
    }
}

}  // namespace firmware

/// The interrupts of a Board: once per program, outside every namespace.
#define FIRMWARE_INTERRUPTS(Board)                          \
    ISR(TIMER1_COMPA_vect) { Board::servo_edge_is_near(); } \
    ISR(TIMER1_OVF_vect) { Board::clock_overflow(); }       \
    ISR(ADC_vect) { Board::conversion_complete(); }         \
    ISR(USART_UDRE_vect) { Board::transmitter_ready(); }    \
    ISR(USART_RX_vect) { Board::byte_received(); }
