# SPDX-License-Identifier: MIT
# Compiles programs for the ATmega328P inside the host build: avr_executable(NAME SOURCES ...
# [OPTIONS ...] [INCLUDES ...] [HEADER header] [LINK_OPTIONS ...] [OBJECTS ...] [ARCHIVES ...]
# [KERNELS] [GROUP group]) makes ${CMAKE_CURRENT_BINARY_DIR}/NAME.elf and sets the target property
# ELF to its path. Sources may be .c, .cpp and .S; OBJECTS come from avr_objects(); KERNELS links
# the library's assembly kernels. HEADER is included first in each .cpp, and is parsed once for all
# that are compiled with the same options. A source must still include what it uses: if no header
# can be precompiled, it is not included. Programs of one source change together: those of a GROUP
# are one step of the build and one target, made by avr_group(group). Their options must not choose
# what they include. avr_grouped(group PROGRAMS ... INPUTS ... COMMANDS ...) adds programs that are made
# otherwise; their command writes what the first of them includes to a file with .d after its name.

find_program(AVR_GCC avr-gcc REQUIRED)
find_program(AVR_GXX avr-g++ REQUIRED)
find_program(AVR_AR avr-ar REQUIRED)
find_program(AVR_OBJCOPY avr-objcopy REQUIRED)

set(AVR_MCU atmega328p)
set(AVR_FREQUENCY 16000000UL)
include(${CMAKE_CURRENT_LIST_DIR}/avr_options.cmake)
# With stabs, which is what -g means to this compiler, it does not precompile a header.
set(AVR_COMMON_OPTIONS ${AVR_CHIP_OPTIONS} -gdwarf-2 -Wall -Wextra -Werror ${AVR_SECTIONS} -fshort-enums)
set(AVR_C_OPTIONS -std=gnu11)
set(AVR_CXX_OPTIONS -std=gnu++14 ${AVR_WITHOUT_RUNTIME})
set(AVR_LIBRARIES -I${CMAKE_SOURCE_DIR}/fixedpoint/src -I${CMAKE_SOURCE_DIR}/engine/src)

# avr_parse(HEADER OPTIONS ...): sets `parsed` to a header that includes it, with its precompiled
# form next to it for programs with these options; or to nothing if there cannot be one. The
# compiler must be at the same addresses in each run, and ccache does not keep objects made like
# this. Macros belong to the programs: if one affects the header, or anything else does not match,
# the compiler reads the header itself. Only Ninja shares rules between folders.
execute_process(COMMAND setarch -R ${AVR_GXX} --version RESULT_VARIABLE AVR_MOVES OUTPUT_QUIET ERROR_QUIET)
function(avr_parse header)
    set(parsed "" PARENT_SCOPE)
    if(NOT AVR_MOVES EQUAL 0 OR NOT CMAKE_GENERATOR MATCHES "Ninja" OR CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache")
        return()
    endif()
    list(FILTER ARGN EXCLUDE REGEX "^-D")
    string(MAKE_C_IDENTIFIER "${header}${ARGN}" name)
    set(made ${CMAKE_BINARY_DIR}/parsed/${name}.hpp)
    set(parsed ${made} PARENT_SCOPE)
    get_property(known GLOBAL PROPERTY avr_parsed_${name})
    if(NOT known)
        set_property(GLOBAL PROPERTY avr_parsed_${name} ON)
        file(GENERATE OUTPUT ${made}.in CONTENT "#include <${header}>\n")
        add_custom_command(OUTPUT ${made} ${made}.gch
            COMMAND ${CMAKE_COMMAND} -E copy ${made}.in ${made}
            COMMAND ${CMAKE_CXX_COMPILER_LAUNCHER} setarch -R ${AVR_GXX} ${AVR_COMMON_OPTIONS} ${AVR_CXX_OPTIONS}
                    ${AVR_LIBRARIES} ${ARGN} -x c++-header -MMD -MF ${made}.d -MT ${made} -c ${made}.in -o ${made}.gch
            DEPENDS ${made}.in DEPFILE ${made}.d COMMENT "AVR ${header} ${ARGN}" VERBATIM)
    endif()
endfunction()

# avr_compile(OUT SOURCE [OPTIONS ...] [INCLUDES ...] [HEADER header]): sets OUT to the command that
# compiles SOURCE, and `parsed` to the header that it needs. OPTIONS come last on the command line,
# so that they override the common ones.
function(avr_compile out source)
    cmake_parse_arguments(ARG "" "HEADER" "OPTIONS;INCLUDES" ${ARGN})
    list(TRANSFORM ARG_INCLUDES PREPEND -I)
    get_filename_component(extension ${source} LAST_EXT)
    set(parsed)
    if(extension STREQUAL ".cpp")
        set(compile ${AVR_GXX} ${AVR_COMMON_OPTIONS} ${AVR_CXX_OPTIONS})
        if(ARG_HEADER)
            avr_parse(${ARG_HEADER} ${ARG_OPTIONS})
        endif()
        if(parsed)
            set(compile setarch -R ${compile} -include ${parsed})
        endif()
    elseif(extension STREQUAL ".c")
        set(compile ${AVR_GCC} ${AVR_COMMON_OPTIONS} ${AVR_C_OPTIONS})
    else()
        set(compile ${AVR_GCC} ${AVR_COMMON_OPTIONS} -x assembler-with-cpp)
    endif()
    # The host compiler's launcher, if there is one (ccache), is used for the cross compiler, too.
    set(${out} ${CMAKE_CXX_COMPILER_LAUNCHER} ${compile} ${AVR_LIBRARIES} ${ARG_INCLUDES} ${ARG_OPTIONS} -c ${source}
        PARENT_SCOPE)
    set(parsed ${parsed} PARENT_SCOPE)
endfunction()

# avr_objects(OUT NAME SOURCES ... [OPTIONS ...] [INCLUDES ...] [HEADER header]): compiles, sets OUT to the objects.
function(avr_objects out name)
    cmake_parse_arguments(ARG "" "HEADER" "SOURCES;OPTIONS;INCLUDES" ${ARGN})
    file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/${name}.dir)
    set(objects)
    foreach(source ${ARG_SOURCES})
        get_filename_component(source ${source} ABSOLUTE)
        get_filename_component(stem ${source} NAME)
        set(object ${CMAKE_CURRENT_BINARY_DIR}/${name}.dir/${stem}.o)
        avr_compile(compile ${source} OPTIONS ${ARG_OPTIONS} INCLUDES ${ARG_INCLUDES} HEADER ${ARG_HEADER})
        add_custom_command(
            OUTPUT ${object}
            COMMAND ${compile} -MMD -MF ${object}.d -o ${object}
            DEPENDS ${source} ${parsed}
            DEPFILE ${object}.d
            COMMENT "AVR ${name}: ${stem}"
            VERBATIM COMMAND_EXPAND_LISTS)
        list(APPEND objects ${object})
    endforeach()
    set(${out} ${objects} PARENT_SCOPE)
endfunction()

# The kernels of the fixed-point library, assembled once for all programs: every assembly file, each
# in a section of its own; as objects, and as an archive from which the linker takes what is used.
file(GLOB kernel_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/fixedpoint/src/fixedpoint/avr/*.S)
avr_objects(AVR_KERNEL_OBJECTS kernels SOURCES ${kernel_sources})
set(AVR_KERNEL_ARCHIVE ${CMAKE_CURRENT_BINARY_DIR}/kernels.a)
add_custom_command(OUTPUT ${AVR_KERNEL_ARCHIVE}
    COMMAND ${CMAKE_COMMAND} -E rm -f ${AVR_KERNEL_ARCHIVE}
    COMMAND ${AVR_AR} rcs ${AVR_KERNEL_ARCHIVE} ${AVR_KERNEL_OBJECTS}
    DEPENDS ${AVR_KERNEL_OBJECTS} COMMENT "AVR kernels.a" VERBATIM)
add_custom_target(avr_kernels DEPENDS ${AVR_KERNEL_OBJECTS} ${AVR_KERNEL_ARCHIVE})
set(linked_kernels ${CMAKE_CURRENT_LIST_DIR}/linked_kernels.awk)

function(avr_executable name)
    cmake_parse_arguments(ARG "KERNELS" "GROUP;HEADER" "SOURCES;OPTIONS;INCLUDES;LINK_OPTIONS;OBJECTS;ARCHIVES" ${ARGN})
    set(elf ${CMAKE_CURRENT_BINARY_DIR}/${name}.elf)
    list(POP_BACK ARG_SOURCES last)
    avr_objects(objects ${name} SOURCES ${ARG_SOURCES} OPTIONS ${ARG_OPTIONS} INCLUDES ${ARG_INCLUDES}
                HEADER ${ARG_HEADER})
    # The last source, usually the only one, is compiled and linked in one step.
    get_filename_component(last ${last} ABSOLUTE)
    get_filename_component(stem ${last} NAME)
    set(object ${CMAKE_CURRENT_BINARY_DIR}/${name}.dir/${stem}.o)
    file(MAKE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/${name}.dir)
    avr_compile(compile ${last} OPTIONS ${ARG_OPTIONS} INCLUDES ${ARG_INCLUDES} HEADER ${ARG_HEADER})
    set(group ${ARG_GROUP})
    if(NOT group)
        set(group ${name})
    endif()
    # The program is made again when a kernel changes that it contains, not when any does.
    set(kernels)
    if(ARG_KERNELS)
        set(kernels ${AVR_KERNEL_OBJECTS})
    endif()
    get_property(programs GLOBAL PROPERTY avr_PROGRAMS_${group})
    list(APPEND programs ${elf})
    list(GET programs 0 first)
    avr_grouped(${group} PROGRAMS ${elf} INPUTS ${last} ${parsed} ${objects} ${ARG_OBJECTS} ${linked_kernels}
        COMMANDS COMMAND ${compile} -MMD -MF ${elf}.d -MT ${elf} -o ${object}
        COMMAND ${AVR_GXX} -mmcu=${AVR_MCU} -Os ${ARG_OPTIONS} -Wl,--gc-sections,-Map=${elf}.map ${ARG_LINK_OPTIONS}
                ${kernels} ${objects} ${object} ${ARG_OBJECTS} ${ARG_ARCHIVES} -lm -o ${elf}
        COMMAND awk -v program=${first} -v script=${linked_kernels} -f ${linked_kernels} ${elf}.map >> ${first}.d)
    if(NOT ARG_GROUP)
        avr_group(${name})
        set_target_properties(${name} PROPERTIES ELF ${elf})
    endif()
endfunction()

function(avr_grouped group)
    cmake_parse_arguments(ARG "" "" "PROGRAMS;INPUTS;COMMANDS" ${ARGN})
    foreach(list PROGRAMS INPUTS COMMANDS)
        set_property(GLOBAL APPEND PROPERTY avr_${list}_${group} ${ARG_${list}})
    endforeach()
endfunction()

function(avr_group group)
    foreach(list PROGRAMS INPUTS COMMANDS)
        get_property(${list} GLOBAL PROPERTY avr_${list}_${group})
    endforeach()
    list(REMOVE_DUPLICATES INPUTS)
    list(GET PROGRAMS 0 first)
    add_custom_command(OUTPUT ${PROGRAMS} ${COMMANDS} DEPENDS ${INPUTS} DEPFILE ${first}.d
        COMMENT "AVR ${group}" VERBATIM COMMAND_EXPAND_LISTS)
    device_target(${group} ${PROGRAMS})
    add_dependencies(${group} avr_kernels)
endfunction()
