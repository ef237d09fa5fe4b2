# SPDX-License-Identifier: MIT
# Tests are built by the target `tests`, not by default, and with -Og: most of them compile for
# longer than they run, and with -O1 for a third longer. Under the sanitizers, which double the time
# of the optimiser, they are not optimised at all, unlike the libraries that they call. A label says
# what a test needs:
#   host     neither the cross compiler nor the simulated chip; runs under the sanitizers too
#   script   as host, a command that runs no program of ours
#   device   programs for the chip of its own
#   slow     fixbench, the device programs of an experiment, or a project or sketch of its own
# The target `quick_tests` builds those of the first three.

set(TEST_OPTIMISATION -Og CACHE STRING "Level at which tests are compiled")
add_custom_target(host_tests)
add_custom_target(quick_tests)
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

# test_program(TARGET LABEL SOURCES ... [LIBRARIES ...] [DEFINITIONS ...] [NEEDS ...] [NAME name]
#              [PREFIX prefix] [MAIN library] [PROPERTIES ...]): a GoogleTest program.
# With NAME it is one test; without, each of its cases is a test, with PREFIX before its name.
function(test_program target label)
    cmake_parse_arguments(ARG "" "NAME;PREFIX;MAIN" "SOURCES;LIBRARIES;DEFINITIONS;NEEDS;PROPERTIES" ${ARGN})
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
        set_tests_properties(${ARG_NAME} PROPERTIES LABELS ${label} ${ARG_PROPERTIES})
    else()
        gtest_discover_tests(${target} TEST_PREFIX ${ARG_PREFIX} NO_PRETTY_VALUES PROPERTIES LABELS ${label} ${ARG_PROPERTIES})
    endif()
    add_labelled(${label} ${target})
endfunction()

# test_command(NAME LABEL COMMAND ... [NEEDS ...]): a test that is a command.
function(test_command name label)
    cmake_parse_arguments(ARG "" "" "COMMAND;NEEDS" ${ARGN})
    add_test(NAME ${name} COMMAND ${ARG_COMMAND})
    set_tests_properties(${name} PROPERTIES LABELS ${label})
    if(ARG_NEEDS)
        add_labelled(${label} ${ARG_NEEDS})
    endif()
endfunction()
