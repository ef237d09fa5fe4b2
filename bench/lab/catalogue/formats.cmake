# SPDX-License-Identifier: GPL-3.0-or-later
# format_rows(OUT LIST): the rows of a list of formats.h, "q8_8, 8, 8;q16_16, 16, 16;...".
set(CATALOGUE_LISTS ${CMAKE_CURRENT_LIST_DIR}/formats.h)
function(format_rows out list)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CATALOGUE_LISTS})
    file(READ ${CATALOGUE_LISTS} text)
    string(REGEX MATCH "#define ${list}[^#*]*" text "${text}")
    string(REGEX MATCHALL "\n *X\\([^)]*" rows "${text}")
    list(TRANSFORM rows REPLACE "\n *X\\(" "")
    set(${out} ${rows} PARENT_SCOPE)
endfunction()

# catalogue_names(OUT FILE PATTERN): sets OUT to what the first group of the pattern matches, wherever
# it occurs in the file, and configures again when the file changes.
function(catalogue_names out file pattern)
    get_filename_component(file ${file} ABSOLUTE)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${file})
    file(READ ${file} text)
    string(REGEX MATCHALL "${pattern}" names "${text}")
    list(TRANSFORM names REPLACE "${pattern}" "\\1")
    set(${out} ${names} PARENT_SCOPE)
endfunction()

# The formats of the library in the catalogue, q4_4;q8_8;..., and those without a sign.
catalogue_names(CATALOGUE_FORMATS ${CATALOGUE_LISTS} "#define FORMAT_(q[a-z0-9_]+)")
catalogue_names(UNSIGNED_FORMATS ${CATALOGUE_LISTS} "#define FORMAT_(u[a-z0-9_]+)")
