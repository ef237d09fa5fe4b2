// SPDX-License-Identifier: MIT
// Runs the tests that are linked.
#include <string.h>

#include "check.hpp"

uint16_t checks = 0, failures = 0;
char first_failing_test[32] = "";
uint16_t first_failing_line = 0, first_failing_row = 0;
uint16_t row = 0;

static const char* running = "";

__attribute__((noinline)) void record(bool holds, uint16_t line) {
    ++checks;
    if (holds || failures++ != 0) return;
    strncpy(first_failing_test, running, sizeof first_failing_test - 1);
    first_failing_line = line;
    first_failing_row = row;
}

extern "C" __attribute__((noinline, used)) void finished() {
    for (;;) {
    }
}

// Null if the file is not linked.
__attribute__((weak)) void test_operators();
__attribute__((weak)) void test_integers();
__attribute__((weak)) void test_small_operations();
__attribute__((weak)) void test_angles();
__attribute__((weak)) void test_shifts();
__attribute__((weak)) void test_checked();
__attribute__((weak)) void test_functions();
__attribute__((weak)) void test_unsigned();
__attribute__((weak)) void test_text();
__attribute__((weak)) void test_constants();
__attribute__((weak)) void test_constant_functions();
__attribute__((weak)) void test_constant_vectors();
__attribute__((weak)) void test_constant_small();

static void run(const char* name, void (*test)()) {
    running = name;
    if (test != nullptr) test();
}

int main() {
    run("operators_test", test_operators);
    run("integers_test", test_integers);
    run("small_operations_test", test_small_operations);
    run("angles_test", test_angles);
    run("shifts_test", test_shifts);
    run("checked_test", test_checked);
    run("functions_test", test_functions);
    run("unsigned_test", test_unsigned);
    run("text_test", test_text);
    run("constants_test", test_constants);
    run("constant_functions_test", test_constant_functions);
    run("constant_vectors_test", test_constant_vectors);
    run("constant_small_test", test_constant_small);
    finished();
}
