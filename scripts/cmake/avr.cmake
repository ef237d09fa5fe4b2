# SPDX-License-Identifier: MIT
# Compiles programs for the ATmega328P inside the host build: avr_executable(NAME SOURCES ...
# [OPTIONS ...] [INCLUDES ...] [LINK_OPTIONS ...]) makes ${CMAKE_CURRENT_BINARY_DIR}/NAME.elf and
# sets the target property ELF to its path. Sources may be .c, .cpp and .S.

find_program(AVR_GCC avr-gcc REQUIRED)
find_program(AVR_GXX avr-g++ REQUIRED)
find_program(AVR_OBJCOPY avr-objcopy REQUIRED)

set(AVR_COMMON_OPTIONS -mmcu=atmega328p -DF_CPU=16000000UL -Os -g -Wall -Wextra -Werror
    -ffunction-sections -fdata-sections -fshort-enums)
set(AVR_C_OPTIONS -std=gnu11)
set(AVR_CXX_OPTIONS -std=gnu++14 -fno-exceptions -fno-rtti -fno-threadsafe-statics)

# The kernels of the fixed-point library: every assembly file, each in a section of its own.
file(GLOB FIXEDPOINT_KERNELS CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/fixedpoint/src/fixedpoint/avr/*.S)

# avr_objects(OUT NAME SOURCES ... [OPTIONS ...] [INCLUDES ...]): compiles, sets OUT to the objects.
# OPTIONS come last on the command line, so that they win over the common ones.
function(avr_objects out name)
    cmake_parse_arguments(ARG "" "" "SOURCES;OPTIONS;INCLUDES" ${ARGN})
    set(includes -I${CMAKE_SOURCE_DIR}/fixedpoint/src -I${CMAKE_SOURCE_DIR}/engine/src)
    foreach(directory ${ARG_INCLUDES})
        list(APPEND includes -I${directory})
    endforeach()
    set(objects)
    foreach(source ${ARG_SOURCES})
        get_filename_component(source ${source} ABSOLUTE)
        get_filename_component(stem ${source} NAME)
        get_filename_component(extension ${source} LAST_EXT)
        set(object ${CMAKE_CURRENT_BINARY_DIR}/${name}.dir/${stem}.o)
        if(extension STREQUAL ".cpp")
            set(compile ${AVR_GXX} ${AVR_COMMON_OPTIONS} ${AVR_CXX_OPTIONS})
        elseif(extension STREQUAL ".c")
            set(compile ${AVR_GCC} ${AVR_COMMON_OPTIONS} ${AVR_C_OPTIONS})
        else()
            set(compile ${AVR_GCC} ${AVR_COMMON_OPTIONS} -x assembler-with-cpp)
        endif()
        add_custom_command(
            OUTPUT ${object}
            COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_CURRENT_BINARY_DIR}/${name}.dir
            COMMAND ${compile} ${includes} ${ARG_OPTIONS} -MMD -MF ${object}.d -c ${source} -o ${object}
            DEPENDS ${source}
            DEPFILE ${object}.d
            COMMENT "AVR ${name}: ${stem}"
            VERBATIM COMMAND_EXPAND_LISTS)
        list(APPEND objects ${object})
    endforeach()
    set(${out} ${objects} PARENT_SCOPE)
endfunction()

function(avr_executable name)
    cmake_parse_arguments(ARG "" "" "SOURCES;OPTIONS;INCLUDES;LINK_OPTIONS" ${ARGN})
    avr_objects(objects ${name} SOURCES ${ARG_SOURCES} OPTIONS ${ARG_OPTIONS} INCLUDES ${ARG_INCLUDES})
    set(elf ${CMAKE_CURRENT_BINARY_DIR}/${name}.elf)
    add_custom_command(
        OUTPUT ${elf}
        COMMAND ${AVR_GXX} -mmcu=atmega328p -Os ${ARG_OPTIONS} -Wl,--gc-sections ${ARG_LINK_OPTIONS} ${objects} -lm -o ${elf}
        DEPENDS ${objects}
        COMMENT "AVR ${name}.elf"
        VERBATIM COMMAND_EXPAND_LISTS)
    add_custom_target(${name} ALL DEPENDS ${elf})
    set_target_properties(${name} PROPERTIES ELF ${elf})
endfunction()
