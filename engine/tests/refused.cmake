# SPDX-License-Identifier: MIT
# cmake -DCOMPILER=... -P refused.cmake: compiles refused.cpp, which must fail, and searches the
# errors for each sentence after `// refused: `, as often as it occurs there.
set(SOURCE ${CMAKE_CURRENT_LIST_DIR}/refused.cpp)
execute_process(COMMAND ${COMPILER} -std=gnu++14 -fsyntax-only -I${CMAKE_CURRENT_LIST_DIR}/../src
        -I${CMAKE_CURRENT_LIST_DIR}/../../fixedpoint/src ${SOURCE}
    RESULT_VARIABLE result ERROR_VARIABLE errors)
if(result EQUAL 0)
    message(FATAL_ERROR "${SOURCE} compiles")
endif()
file(STRINGS ${SOURCE} expected REGEX "// refused: ")
list(LENGTH expected count)
if(count EQUAL 0)
    message(FATAL_ERROR "${SOURCE} names nothing to refuse")
endif()
foreach(line ${expected})
    string(REGEX REPLACE ".*// refused: " "" sentence "${line}")
    string(FIND "${errors}" "error: static assertion failed: ${sentence}" at)
    if(at EQUAL -1)
        message(FATAL_ERROR "Not refused: ${sentence}\n${errors}")
    endif()
    # Each error counts for one line only.
    string(SUBSTRING "${errors}" 0 ${at} before)
    math(EXPR at "${at} + 1")
    string(SUBSTRING "${errors}" ${at} -1 behind)
    set(errors "${before}${behind}")
endforeach()
