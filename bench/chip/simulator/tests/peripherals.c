// SPDX-License-Identifier: GPL-3.0-or-later
// Programs that exercise the peripherals where libsimavr has defects.
#include "workarounds.h"

// --- USART0 ---

static void uart_start(uint8_t format) {
    UBRR0 = 3;  // 16 cycles * (3 + 1) a bit: 250000 baud
    UCSR0C = format;
    UCSR0B = 1 << TXEN0 | 1 << RXEN0;
}

static void send_polled(uint8_t byte) {
    while (!(UCSR0A & 1 << UDRE0)) {
    }
    UDR0 = byte;
    mark(byte);
}

static void send_three(uint8_t format) {
    uart_start(format);
    for (uint8_t byte = 1; byte <= 3; ++byte) send_polled(byte);
    while (!(UCSR0A & 1 << TXC0)) {
    }
    mark(4);
    done();
}
TEST_PROGRAM uart_8n1(void) { send_three(1 << UCSZ01 | 1 << UCSZ00); }
TEST_PROGRAM uart_7e2(void) { send_three(1 << UPM01 | 1 << USBS0 | 1 << UCSZ01); }

// At double speed. A one written to TXC0 clears only that flag.
TEST_PROGRAM uart_double_speed(void) {
    uart_start(1 << UCSZ01 | 1 << UCSZ00);
    UBRR0 = 7;
    UCSR0A = 1 << U2X0;
    for (uint8_t byte = 1; byte <= 3; ++byte) send_polled(byte);
    while (!(UCSR0A & 1 << TXC0)) {
    }
    UCSR0A = 1 << TXC0 | 1 << U2X0;
    mark(UCSR0A);
    done();
}

TEST_PROGRAM uart_off(void) {
    UDR0 = 1;
    for (volatile uint16_t i = 0; i < 2000; ++i) {
    }
    done();
}

// Every second call leaves the data register empty, so that it is called again.
static volatile uint8_t next_byte;
ISR(USART_UDRE_vect) {
    static uint8_t idle;
    idle = !idle;
    if (idle) return;
    UDR0 = ++next_byte;
    if (next_byte == 5) UCSR0B &= ~(1 << UDRIE0);
}
TEST_PROGRAM uart_interrupt(void) {
    uart_start(1 << UCSZ01 | 1 << UCSZ00);
    UCSR0B |= 1 << UDRIE0;
    sei();
    while (next_byte < 5) {
    }
    while (!(UCSR0A & 1 << TXC0)) {
    }
    mark(next_byte);
    done();
}

TEST_PROGRAM uart_echo(void) {
    uart_start(1 << UCSZ01 | 1 << UCSZ00);
    for (uint8_t i = 0; i < 3; ++i) {
        while (!(UCSR0A & 1 << RXC0)) {
        }
        mark(UDR0);
    }
    done();
}

// Instructions of one cycle, so that the host sees flags and interrupts exact to the cycle.
TEST_PROGRAM uart_listen(void) {
    uart_start(1 << UCSZ01 | 1 << UCSZ00);
    asm volatile(".rept 3000\n nop\n .endr");
    done();
}

// --- Timer1 ---

enum { compare_mark = 1, overflow_mark = 2 };
ISR(TIMER1_COMPA_vect) { mark(compare_mark); }
ISR(TIMER1_OVF_vect) { mark(overflow_mark); }

// Fast PWM with ICR1 as TOP; the compare value changes in the second period, after its match.
TEST_PROGRAM timer1_fast_pwm(void) {
    ICR1 = 1999;
    OCR1A = 499;
    TCCR1A = 1 << WGM11;
    TIMSK1 = 1 << OCIE1A | 1 << TOIE1;
    sei();
    TCCR1B = 1 << WGM13 | 1 << WGM12 | 1 << CS10;
    for (volatile uint16_t i = 0; i < 200; ++i) {
    }
    OCR1A = 999;
    for (volatile uint16_t i = 0; i < 800; ++i) {
    }
    done();
}

// All of Timer1's flags are set; two writes clear one each.
TEST_PROGRAM timer1_flags(void) {
    OCR1A = 10;
    OCR1B = 20;
    TCNT1 = 0;
    TCCR1B = 1 << CS10;
    while (!(TIFR1 & 1 << TOV1)) {
    }
    TCCR1B = 0;
    mark(TIFR1);
    const uint8_t one = 1 << OCF1A;
    TIFR1 = one;
    mark(TIFR1);
    asm volatile("sbi %0, %1" ::"I"(_SFR_IO_ADDR(TIFR1)), "I"(TOV1));
    mark(TIFR1);
    done();
}

// --- Pins ---

TEST_PROGRAM toggle_one_pin(void) {
    DDRD = 0xf0;
    PORTD = 0xa0;
    asm volatile("sbi %0, 4" ::"I"(_SFR_IO_ADDR(PIND)));
    mark(PORTD);
    done();
}

TEST_PROGRAM pulse_pin(void) {
    DDRD |= 1 << 7;
    PORTD |= 1 << 7;
    asm volatile("nop\n nop\n nop");
    PORTD &= ~(1 << 7);
    mark(PIND & 1 << 2);
    done();
}

// --- ADC ---

static void convert(uint8_t mux) {
    ADMUX = mux;
    ADCSRA |= 1 << ADSC;
    mark(1);
    while (ADCSRA & 1 << ADSC) {
    }
    mark(2);
}

TEST_PROGRAM adc_results(void) {
    ADCSRA = 1 << ADEN | 1 << ADPS2 | 1 << ADPS1 | 1 << ADPS0;
    convert(1 << REFS0 | 0);
    mark(ADCL);
    mark(ADCH);
    convert(1 << REFS0 | 3);
    ADMUX = 1 << REFS0 | 0;  // does not matter: the conversion is over
    mark(ADCL);
    mark(ADCH);
    convert(1 << REFS1 | 1 << REFS0 | 1 << ADLAR | 3);
    mark(ADCH);
    done();
}

// A conversion that ends between the reads of ADCL and ADCH is lost.
TEST_PROGRAM adc_lock(void) {
    ADCSRA = 1 << ADEN | 1 << ADPS2;
    convert(1 << REFS0 | 0);
    mark(ADCL);
    convert(1 << REFS0 | 3);
    mark(ADCH);
    done();
}
