# SPDX-License-Identifier: MIT
# cmake -DDIRECTORY=... -P install.cmake: installs avr8js in that folder, as package-lock.json pins
# it, unless it is already there. If the registry cannot be reached, it reports that the tests
# against avr8js are skipped; any other problem is an error.
foreach(tool node npm)
    find_program(${tool} ${tool})
    if(NOT ${tool})
        message(FATAL_ERROR "avr8js, the second simulator, needs '${tool}': apt install nodejs npm")
    endif()
endforeach()
file(COPY ${CMAKE_CURRENT_LIST_DIR}/package.json ${CMAKE_CURRENT_LIST_DIR}/package-lock.json
     ${CMAKE_CURRENT_LIST_DIR}/call.mjs
     ${CMAKE_CURRENT_LIST_DIR}/step.mjs DESTINATION ${DIRECTORY})
file(SHA256 ${DIRECTORY}/package-lock.json wanted)
set(stamp ${DIRECTORY}/node_modules/installed-lock)
if(EXISTS ${stamp})
    file(READ ${stamp} installed)
endif()
if(NOT "${installed}" STREQUAL "${wanted}")
    execute_process(COMMAND ${npm} ci --no-audit --no-fund WORKING_DIRECTORY ${DIRECTORY}
                    RESULT_VARIABLE failed ERROR_VARIABLE reason)
    if(reason MATCHES "ENOTFOUND|EAI_AGAIN|ECONNREFUSED|ECONNRESET|ETIMEDOUT|ENETUNREACH|_CERT_|CERT_IN_CHAIN")
        message("SKIPPED: no way to the npm registry (${CMAKE_MATCH_0}): no tests against avr8js")
        return()
    elseif(failed)
        message(FATAL_ERROR "npm ci failed: avr8js could not be installed:\n${reason}")
    endif()
    file(WRITE ${stamp} ${wanted})
endif()
