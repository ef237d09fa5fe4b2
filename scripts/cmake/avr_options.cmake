# SPDX-License-Identifier: MIT
# How code for the chip AVR_MCU at AVR_FREQUENCY is compiled, in this project and, with
# avr_toolchain.cmake, in others.
set(AVR_CHIP_OPTIONS -mmcu=${AVR_MCU} -DF_CPU=${AVR_FREQUENCY} -Os)
set(AVR_SECTIONS -ffunction-sections -fdata-sections)
set(AVR_WITHOUT_RUNTIME -fno-exceptions -fno-rtti -fno-threadsafe-statics)
