# SPDX-License-Identifier: MIT
# Tests are built by the target `tests` and not by default. They compile at -O1: most of them are
# compiled for longer than they run.

add_custom_target(tests)
# The tests that need neither the device's toolchain nor the simulated chip, labelled `host`.
add_custom_target(host_tests)
add_dependencies(tests host_tests)

# test_needs(TARGET ...): what a test runs or reads, built with the tests.
function(test_needs)
    add_dependencies(tests ${ARGN})
endfunction()

# test_program(TARGET LABEL SOURCES ... [LIBRARIES ...] [DEFINITIONS ...] [NEEDS ...] [NAME name]
#              [PREFIX prefix] [MAIN library] [PROPERTIES ...]): a GoogleTest program.
# With NAME it is one test; without, each of its cases is one, with PREFIX before its name.
function(test_program target label)
    cmake_parse_arguments(ARG "" "NAME;PREFIX;MAIN" "SOURCES;LIBRARIES;DEFINITIONS;NEEDS;PROPERTIES" ${ARGN})
    if(NOT ARG_MAIN)
        set(ARG_MAIN GTest::gtest_main)
    endif()
    add_executable(${target} EXCLUDE_FROM_ALL ${ARG_SOURCES})
    target_compile_options(${target} PRIVATE -O1)
    target_link_libraries(${target} PRIVATE ${ARG_LIBRARIES} ${ARG_MAIN})
    target_compile_definitions(${target} PRIVATE ${ARG_DEFINITIONS})
    if(ARG_NEEDS)
        add_dependencies(${target} ${ARG_NEEDS})
    endif()
    if(ARG_NAME)
        add_test(NAME ${ARG_NAME} COMMAND ${target} --gtest_brief=1)
        set_tests_properties(${ARG_NAME} PROPERTIES LABELS ${label} ${ARG_PROPERTIES})
    else()
        gtest_discover_tests(${target} TEST_PREFIX ${ARG_PREFIX} PROPERTIES LABELS ${label} ${ARG_PROPERTIES})
    endif()
    add_dependencies(tests ${target})
    if(label STREQUAL "host")
        add_dependencies(host_tests ${target})
    endif()
endfunction()

# test_command(NAME LABEL COMMAND ... [NEEDS ...]): a test that is a command.
function(test_command name label)
    cmake_parse_arguments(ARG "" "" "COMMAND;NEEDS" ${ARGN})
    add_test(NAME ${name} COMMAND ${ARG_COMMAND})
    set_tests_properties(${name} PROPERTIES LABELS ${label})
    if(ARG_NEEDS)
        test_needs(${ARG_NEEDS})
    endif()
endfunction()
