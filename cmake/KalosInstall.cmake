# What the modules, the package and the applications do not install themselves, and the Debian package.
include(CMakePackageConfigHelpers)
configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/KalosConfig.cmake.in" "${CMAKE_BINARY_DIR}/KalosConfig.cmake"
  INSTALL_DESTINATION "${KALOS_CMAKE_DIRECTORY}")
write_basic_package_version_file("${CMAKE_BINARY_DIR}/KalosConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${CMAKE_BINARY_DIR}/KalosConfig.cmake" "${CMAKE_BINARY_DIR}/KalosConfigVersion.cmake"
  DESTINATION "${KALOS_CMAKE_DIRECTORY}")
install(DIRECTORY data DESTINATION "${CMAKE_INSTALL_DATADIR}/kalos" PATTERN "*.py" EXCLUDE)
install(DIRECTORY examples DESTINATION "${CMAKE_INSTALL_DATADIR}/kalos" USE_SOURCE_PERMISSIONS PATTERN "__pycache__" EXCLUDE)  # beside data
install(FILES README.md LICENSE CHANGELOG.md CITATION.cff DESTINATION "${CMAKE_INSTALL_DOCDIR}")
# ParaView's build of a plugin installs the archives that the plugin was linked from.
install(CODE "file(GLOB archives \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/libvtkKalos*CS.a\")
if (archives)
  file(REMOVE \${archives})
endif ()")

# cpack --config build/CPackConfig.cmake makes kalos_VERSION_ARCHITECTURE.deb.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME kalos)
set(CPACK_PACKAGE_CONTACT "The Kalos authors <kalos@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "python3-mpi4py, openmpi-bin, python3-argcomplete")
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}")
set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3, python3-numpy, python3-matplotlib, python3-scipy")
if (KALOS_WITH_PARAVIEW)
  string(APPEND CPACK_DEBIAN_PACKAGE_DEPENDS ", paraview, python3-paraview")
endif ()
include(CPack)
