# SPDX-License-Identifier: MIT
# cmake -DDIRECTORY=... -P install.cmake: installs avr8js there as package-lock.json pins it, unless it
# is installed already.
foreach(tool node npm)
    find_program(${tool} ${tool})
    if(NOT ${tool})
        message(FATAL_ERROR "avr8js, the second simulator, needs '${tool}': apt install nodejs npm")
    endif()
endforeach()
file(COPY ${CMAKE_CURRENT_LIST_DIR}/package.json ${CMAKE_CURRENT_LIST_DIR}/package-lock.json
     ${CMAKE_CURRENT_LIST_DIR}/call.mjs DESTINATION ${DIRECTORY})
file(SHA256 ${DIRECTORY}/package-lock.json wanted)
set(stamp ${DIRECTORY}/node_modules/installed-lock)
if(EXISTS ${stamp})
    file(READ ${stamp} installed)
endif()
if(NOT "${installed}" STREQUAL "${wanted}")
    execute_process(COMMAND ${npm} ci --no-audit --no-fund WORKING_DIRECTORY ${DIRECTORY}
                    RESULT_VARIABLE failed)
    if(failed)
        message(FATAL_ERROR "npm ci failed: avr8js could not be installed from the npm registry")
    endif()
    file(WRITE ${stamp} ${wanted})
endif()
