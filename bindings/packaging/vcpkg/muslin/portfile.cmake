# portfile.cmake: muslin for vcpkg, an overlay port: vcpkg install muslin --overlay-ports=bindings/packaging/vcpkg
#
# Not run here: the address and the checksum are those of a release. Libraries of the release build alone, static or
# shared as the triplet has it; the command, which needs EGL, is left out.
set(VCPKG_BUILD_TYPE release)

vcpkg_download_distfile(ARCHIVE
    URLS "https://example.org/muslin/muslin-${VERSION}.tar.gz"
    FILENAME "muslin-${VERSION}.tar.gz"
    SHA512 0
)
vcpkg_extract_source_archive(SOURCE_PATH ARCHIVE "${ARCHIVE}")

vcpkg_find_acquire_program(PKGCONFIG)
set(ENV{PKG_CONFIG} "${PKGCONFIG}")
set(ENV{PKG_CONFIG_PATH} "${CURRENT_INSTALLED_DIR}/lib/pkgconfig")
set(OUT "${CURRENT_BUILDTREES_DIR}/${TARGET_TRIPLET}")
set(LIBRARIES "")
foreach(NAME IN ITEMS libmuslin libmuslin-print libmuslin-exchange libmuslin-catalogue)
    list(APPEND LIBRARIES "${OUT}/lib/${NAME}.a" "${OUT}/lib/${NAME}.so.${VERSION}")
endforeach()
vcpkg_execute_required_process(
    COMMAND make -j${VCPKG_CONCURRENCY} V=1 "OUT=${OUT}" ${LIBRARIES}
    WORKING_DIRECTORY "${SOURCE_PATH}"
    LOGNAME "build-${TARGET_TRIPLET}"
)
vcpkg_execute_required_process(
    COMMAND sh lib/install.sh "${OUT}" "" "${CURRENT_PACKAGES_DIR}" lib "${VERSION}" 1
    WORKING_DIRECTORY "${SOURCE_PATH}"
    LOGNAME "install-${TARGET_TRIPLET}"
)
if(VCPKG_LIBRARY_LINKAGE STREQUAL "static")
    file(GLOB OTHERS "${CURRENT_PACKAGES_DIR}/lib/*.so*")
else()
    file(GLOB OTHERS "${CURRENT_PACKAGES_DIR}/lib/*.a")
endif()
file(REMOVE_RECURSE ${OTHERS} "${CURRENT_PACKAGES_DIR}/bin" "${CURRENT_PACKAGES_DIR}/share/man")
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/muslin)
vcpkg_fixup_pkgconfig()
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE")
