# What `cmake --install` puts where, and the Debian package. Component development: the analytic reference as fretval::mdr;
# component program: fretval with its data, which it finds beside itself (comparison/support/folders.h).
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS mdr EXPORT fretvalTargets ARCHIVE COMPONENT development)
install(DIRECTORY mdr DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/fretval COMPONENT development
  FILES_MATCHING PATTERN "*.h")
set(config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/fretval)
install(EXPORT fretvalTargets NAMESPACE fretval:: DESTINATION ${config_folder} COMPONENT development)
configure_package_config_file(cmake/fretvalConfig.cmake.in ${PROJECT_BINARY_DIR}/fretvalConfig.cmake
  INSTALL_DESTINATION ${config_folder})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/fretvalConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/fretvalConfig.cmake ${PROJECT_BINARY_DIR}/fretvalConfigVersion.cmake
  DESTINATION ${config_folder} COMPONENT development)

if(NOT FRETVAL_MDR_ONLY)
  # The program knows its verbs best. Written when it is installed, so that whoever has built the program alone can.
  install(CODE "foreach(page man bash)
    execute_process(COMMAND ${CMAKE_COMMAND} -E env ASAN_OPTIONS=detect_leaks=0 $<TARGET_FILE:fretval> pages \${page}
      OUTPUT_FILE ${PROJECT_BINARY_DIR}/fretval.\${page} RESULT_VARIABLE failure)
    if(failure)
      message(FATAL_ERROR \"$<TARGET_FILE:fretval> pages \${page}: \${failure}\")
    endif()
  endforeach()" COMPONENT program)
  install(TARGETS fretval RUNTIME COMPONENT program)
  install(FILES ${PROJECT_BINARY_DIR}/fretval.man DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 RENAME fretval.1
    COMPONENT program)
  install(FILES ${PROJECT_BINARY_DIR}/fretval.bash RENAME fretval
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
  install(FILES python/fretval.py DESTINATION ${CMAKE_INSTALL_DATADIR}/fretval/python COMPONENT program)
  install(DIRECTORY meshes/small DESTINATION ${CMAKE_INSTALL_DATADIR}/fretval/meshes COMPONENT program)
  install(DIRECTORY cases/check cases/extremes cases/examples cases/gallery cases/benchmarks DESTINATION ${CMAKE_INSTALL_DATADIR}/fretval/cases
    COMPONENT program)
  install(FILES README.md CHANGELOG.md LICENSE CITATION.cff DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/fretval
    COMPONENT program)
  install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/fretval/docs COMPONENT program
    FILES_MATCHING PATTERN "*.md" PATTERN "*.json" PATTERN "*.jq" PATTERN "*.svg" PATTERN "*.png" PATTERN "*.py" PATTERN "*.cc" PATTERN "*.yml" PATTERN "CMakeLists.txt")
endif()

# `cpack` in the build folder makes one package for each component.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "the fretval authors")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION
    "finite elements against dimensionality reduction for fretting on elastomers
The program fretval computes the fretting of a rigid indenter on a viscoelastic half-space by finite elements and by
the method of dimensionality reduction (MDR), compares stick zones, forces, energies and wear, and writes a report.")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION
    "method of dimensionality reduction for fretting on elastomers, C++ library
Headers, static library and CMake files of fretval::mdr, the analytic reference of the program fretval: stick radii,
limiting profiles, surface fields and wear of a rigid indenter on a viscoelastic half-space, for programs of your own.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME fretval)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libfretval-mdr-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "libeigen3-dev, libboost-dev")
include(CPack)
