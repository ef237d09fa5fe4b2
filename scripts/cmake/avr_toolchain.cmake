# SPDX-License-Identifier: MIT
# Toolchain file for separate projects on an ATmega328P at 16 MHz, or on another chip by AVR_MCU and
# AVR_FREQUENCY: cmake -DCMAKE_TOOLCHAIN_FILE=avr_toolchain.cmake ...
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR avr)
set(AVR_MCU atmega328p CACHE STRING "The chip, as avr-gcc names it")
set(AVR_FREQUENCY 16000000UL CACHE STRING "Its clock in Hz")
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES AVR_MCU AVR_FREQUENCY)

set(CMAKE_C_COMPILER avr-gcc)
set(CMAKE_CXX_COMPILER avr-g++)
set(CMAKE_EXECUTABLE_SUFFIX_C .elf)
set(CMAKE_EXECUTABLE_SUFFIX_CXX .elf)
include(${CMAKE_CURRENT_LIST_DIR}/avr_options.cmake)
list(JOIN AVR_CHIP_OPTIONS " " chip)
list(JOIN AVR_SECTIONS " " sections)
list(JOIN AVR_WITHOUT_RUNTIME " " without_runtime)
set(CMAKE_C_FLAGS_INIT "${chip} ${sections}")
set(CMAKE_ASM_FLAGS_INIT "${chip} ${sections}")
set(CMAKE_CXX_FLAGS_INIT "${chip} ${sections} ${without_runtime}")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-Wl,--gc-sections")
