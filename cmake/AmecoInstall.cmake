# What `cmake --install` puts where, the library for other programs, and the Debian package.

include(CMakePackageConfigHelpers)

# The library: find_package(ameco), target ameco::core, headers as <prefix>/include/ameco/core/...
set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/ameco)
set_target_properties(ameco_core PROPERTIES EXPORT_NAME core)
set_target_properties(ameco_settings PROPERTIES EXPORT_NAME settings)
install(TARGETS ameco_core ameco_settings EXPORT ameco-targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development)
install(EXPORT ameco-targets NAMESPACE ameco:: DESTINATION ${config_folder} COMPONENT development)
install(DIRECTORY core DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/ameco COMPONENT development
    FILES_MATCHING PATTERN "*.h")
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/ameco-config.cmake.in"
    "${PROJECT_BINARY_DIR}/ameco-config.cmake" INSTALL_DESTINATION ${config_folder})
write_basic_package_version_file("${PROJECT_BINARY_DIR}/ameco-config-version.cmake"
    COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/ameco-config.cmake"
    "${PROJECT_BINARY_DIR}/ameco-config-version.cmake"
    DESTINATION ${config_folder} COMPONENT development)

# The program's papers.
install(FILES docs/man/ameco.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES resources/completions/ameco.bash
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME ameco)
install(FILES LICENSE CHANGELOG.md README.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
# As in the repository, so that the links between pages work.
install(FILES docs/README.md docs/reproduction.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs)
install(DIRECTORY docs/user docs/theory docs/dev docs/pictures DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs)

# `cpack` in the build folder makes ameco_<version>_<architecture>.deb.
# Packing and installing take what is built, the target `program`, and do not build the tests first.
set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME ameco)
set(CPACK_PACKAGE_VENDOR "The ameco authors")
set(CPACK_PACKAGE_CONTACT "The ameco authors <ameco@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DESCRIPTION "Makes the sequence of coarser meshes that geometric multigrid needs from one
extremely stretched mesh of triangles or tetrahedra. A batch program, a
window, a C++ library and a Python module.")
if(AMECO_BUILD_PYTHON)
    # Recommended only: the program needs no Python, and a cluster's node may have none.
    math(EXPR next_minor "${AMECO_PYTHON_MINOR} + 1")
    set(CPACK_DEBIAN_PACKAGE_RECOMMENDS
        "python3 (>= 3.${AMECO_PYTHON_MINOR}), python3 (<< 3.${next_minor}), python3-numpy")
    set(CPACK_DEBIAN_PACKAGE_SUGGESTS "python3-scipy")
    set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA "${CMAKE_CURRENT_LIST_DIR}/debian/postinst"
        "${CMAKE_CURRENT_LIST_DIR}/debian/prerm")
endif()
include(CPack)
