# SPDX-License-Identifier: MIT
# Tests are built by the target `tests`, not by default, and with -Og: most of them compile for
# longer than they run, and with -O1 for a third longer. Under the sanitizers, which double the time
# of the optimiser, they are not optimised at all, unlike the libraries that they call. A label says
# what a test needs:
#   host     neither the cross compiler nor the simulated chip; runs under the sanitizers too
#   script   as host, a command that runs no program of ours
#   device   programs for the chip of its own
#   slow     fixbench, the device programs of an experiment, a project or sketch of its own, a proof,
#            or many compilations
# Slow tests run first: one that began last would keep the other cores waiting.
# The target `quick_tests` builds those of the first three, and `run_quick_tests` runs them: each only
# if its program, the device programs that it NEEDS, or the sources that it READS have changed since
# it last passed.

set(TEST_OPTIMISATION -Og CACHE STRING "Level at which tests are compiled")
set(order_of_slow COST 1000)
add_custom_target(host_tests)
add_custom_target(quick_tests)
add_custom_target(run_quick_tests)
add_custom_target(tests)
add_dependencies(quick_tests host_tests)
add_dependencies(tests quick_tests)

# add_labelled(LABEL TARGETS ...): builds the targets with the tests of that label.
function(add_labelled label)
    if(label MATCHES "^(host|script)$")
        add_dependencies(host_tests ${ARGN})
    elseif(label STREQUAL "device")
        add_dependencies(quick_tests ${ARGN})
    elseif(label STREQUAL "slow")
        add_dependencies(tests ${ARGN})
    else()
        message(FATAL_ERROR "a test's label is host, script, device or slow, not ${label}")
    endif()
endfunction()

# Headers that nearly every test includes are parsed once for all tests: GoogleTest alone takes
# longer than the rest of most tests. ccache does not keep objects made with a precompiled header.
if(CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache")
    set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()
file(GENERATE OUTPUT ${CMAKE_BINARY_DIR}/test_headers.cpp CONTENT "")
add_library(test_headers OBJECT EXCLUDE_FROM_ALL ${CMAKE_BINARY_DIR}/test_headers.cpp)
target_compile_options(test_headers PRIVATE ${TEST_OPTIMISATION})
target_link_libraries(test_headers PRIVATE GTest::gtest fmt::fmt)
target_precompile_headers(test_headers PRIVATE <gtest/gtest.h> <fmt/format.h> <filesystem> <fstream>)

# quick_test(NAME LABEL COMMAND ... [NEEDS targets ...] [READS patterns ...]): makes a test one of
# run_quick_tests, unless it is slow. A pattern with a * is of files in that folder of the source tree
# and all below.
function(quick_test name label)
    cmake_parse_arguments(ARG "" "" "COMMAND;NEEDS;READS" ${ARGN})
    if(label STREQUAL "slow")
        return()
    endif()
    set(read)
    foreach(path ${ARG_READS})
        set(files ${CMAKE_SOURCE_DIR}/${path})
        if(path MATCHES "[*]")
            file(GLOB_RECURSE files CONFIGURE_DEPENDS ${files})
        endif()
        list(APPEND read ${files})
    endforeach()
    # A target may be defined after the test that needs it.
    list(TRANSFORM ARG_NEEDS REPLACE "(.+)" "$<TARGET_PROPERTY:\\1,PROGRAMS>" OUTPUT_VARIABLE programs)
    string(REPLACE "/" "_" run run_${name})
    set(passed ${CMAKE_BINARY_DIR}/passed/${run})
    add_custom_command(OUTPUT ${passed}
        COMMAND ${CMAKE_SOURCE_DIR}/scripts/cmake/run_test.sh ${passed} ${ARG_COMMAND}
        DEPENDS ${read} ${programs} ${ARG_NEEDS}
        COMMENT "Test ${name}" VERBATIM COMMAND_EXPAND_LISTS)
    add_custom_target(${run} DEPENDS ${passed})
    add_dependencies(run_quick_tests ${run})
    set_property(GLOBAL APPEND PROPERTY quick_tests_need ${ARG_NEEDS})
endfunction()

# Without its PROGRAMS, a target of device programs would not run a test again.
function(check_quick_tests)
    get_property(needed GLOBAL PROPERTY quick_tests_need)
    foreach(target ${needed})
        get_target_property(type ${target} TYPE)
        get_target_property(programs ${target} PROGRAMS)
        if(type STREQUAL "UTILITY" AND NOT programs)
            message(FATAL_ERROR "${target} must set PROGRAMS")
        endif()
    endforeach()
endfunction()
cmake_language(DEFER DIRECTORY ${CMAKE_SOURCE_DIR} CALL check_quick_tests)

# device_target(NAME PROGRAMS ...): a target that makes programs for the chip.
function(device_target name)
    add_custom_target(${name} DEPENDS ${ARGN})
    set_target_properties(${name} PROPERTIES PROGRAMS "${ARGN}")
endfunction()

# device_targets(NAME targets ...): a target for several of them.
function(device_targets name)
    set(programs)
    foreach(target ${ARGN})
        get_target_property(further ${target} PROGRAMS)
        list(APPEND programs ${further})
    endforeach()
    device_target(${name} ${programs})
    add_dependencies(${name} ${ARGN})
endfunction()

# test_program(TARGET LABEL SOURCES ... [LIBRARIES ...] [DEFINITIONS ...] [NEEDS ...] [READS ...]
#              [PARTS ...] [NAME name] [PREFIX prefix] [MAIN library] [PROPERTIES ...]): a GoogleTest
# program. With NAME it is one test; without, each of its cases is a test, with PREFIX before its name.
# PARTS are suffixes of targets `subjects_PART`, of which the cases whose names end with /PART need
# only that one: run_quick_tests runs them apart.
function(test_program target label)
    cmake_parse_arguments(ARG "" "NAME;PREFIX;MAIN" "SOURCES;LIBRARIES;DEFINITIONS;NEEDS;READS;PARTS;PROPERTIES" ${ARGN})
    if(NOT ARG_MAIN)
        set(ARG_MAIN GTest::gtest_main)
    endif()
    add_executable(${target} EXCLUDE_FROM_ALL ${ARG_SOURCES})
    target_compile_options(${target} PRIVATE ${TEST_OPTIMISATION})
    target_link_libraries(${target} PRIVATE ${ARG_LIBRARIES} ${ARG_MAIN} fmt::fmt)
    target_precompile_headers(${target} REUSE_FROM test_headers)
    target_compile_definitions(${target} PRIVATE ${ARG_DEFINITIONS})
    if(ARG_NEEDS)
        add_dependencies(${target} ${ARG_NEEDS})
    endif()
    if(ARG_NAME)
        add_test(NAME ${ARG_NAME} COMMAND ${target} --gtest_brief=1)
        set_tests_properties(${ARG_NAME} PROPERTIES LABELS ${label} ${order_of_${label}} ${ARG_PROPERTIES})
    else()
        gtest_discover_tests(${target} TEST_PREFIX ${ARG_PREFIX} NO_PRETTY_VALUES PROPERTIES LABELS ${label} ${ARG_PROPERTIES})
        set(ARG_NAME ${ARG_PREFIX}${target})
    endif()
    set(run $<TARGET_FILE:${target}> --gtest_brief=1)
    foreach(part ${ARG_PARTS})
        quick_test(${ARG_NAME}_${part} ${label} COMMAND ${run} --gtest_filter=*/${part}
            NEEDS ${target} subjects_${part} READS ${ARG_READS})
    endforeach()
    if(NOT ARG_PARTS)
        quick_test(${ARG_NAME} ${label} COMMAND ${run} NEEDS ${target} ${ARG_NEEDS} READS ${ARG_READS})
    endif()
    add_labelled(${label} ${target})
endfunction()

# test_command(NAME LABEL COMMAND ... [NEEDS ...] [READS ...]): a test that is a command.
function(test_command name label)
    cmake_parse_arguments(ARG "" "" "COMMAND;NEEDS;READS" ${ARGN})
    add_test(NAME ${name} COMMAND ${ARG_COMMAND})
    set_tests_properties(${name} PROPERTIES LABELS ${label} ${order_of_${label}})
    if(ARG_NEEDS)
        add_labelled(${label} ${ARG_NEEDS})
    endif()
    if(NOT ARG_READS AND NOT label STREQUAL "slow")
        message(FATAL_ERROR "${name} must be given READS")
    endif()
    quick_test(${name} ${label} COMMAND ${ARG_COMMAND} NEEDS ${ARG_NEEDS} READS ${ARG_READS})
endfunction()
