# SPDX-License-Identifier: MIT
# vcpkg install fixbench-fixed --overlay-ports=fixedpoint/vcpkg: a port of the tree that it lies in,
# headers only.
set(SOURCE_PATH "${CURRENT_PORT_DIR}/..")
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}")
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME fixedpoint CONFIG_PATH lib/cmake/fixedpoint)
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug" "${CURRENT_PACKAGES_DIR}/lib")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
