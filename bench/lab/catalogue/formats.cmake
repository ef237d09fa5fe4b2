# SPDX-License-Identifier: GPL-3.0-or-later
# CATALOGUE_FORMATS: the formats of the library in the catalogue, q4_4;q8_8;..., and UNSIGNED_FORMATS,
# those without a sign.
set(catalogue ${CMAKE_CURRENT_LIST_DIR}/subjects.h)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${catalogue})
file(STRINGS ${catalogue} CATALOGUE_FORMATS REGEX "^#define FORMAT_q")
file(STRINGS ${catalogue} UNSIGNED_FORMATS REGEX "^#define FORMAT_u")
foreach(formats CATALOGUE_FORMATS UNSIGNED_FORMATS)
    list(TRANSFORM ${formats} REPLACE "^#define FORMAT_([a-z0-9_]+).*" "\\1")
endforeach()
