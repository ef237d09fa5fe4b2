# SPDX-License-Identifier: MIT
# Fails unless SOURCE fails to compile, and for the reason that its second line states. The rest of
# the program is right: it compiles with that one assertion met, as the compiler prints no other.
file(STRINGS ${SOURCE} lines LIMIT_COUNT 2)
list(GET lines 1 sentence)
string(SUBSTRING "${sentence}" 3 -1 sentence)
execute_process(COMMAND ${COMPILER} ${OPTIONS} -fsyntax-only ${SOURCE}
                RESULT_VARIABLE status ERROR_VARIABLE messages)
if(status EQUAL 0)
    message(FATAL_ERROR "It compiles, and should not: ${sentence}")
endif()
string(FIND "${messages}" "static assertion failed: ${sentence}" found)
string(REGEX MATCHALL "error: " errors "${messages}")
list(LENGTH errors count)
if(found EQUAL -1 OR NOT count EQUAL 1)
    message(FATAL_ERROR "It fails for another reason than '${sentence}':\n${messages}")
endif()
