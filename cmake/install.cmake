# `cmake --install` puts the libraries, their headers and a CMake package below the prefix, and
# unless GRASPDB_RUNTIME_ONLY the program (cli/CMakeLists.txt) and all data but the weights, which
# come along always.
include(CMakePackageConfigHelpers)
set(GRASPDB_DATA_DIR ${CMAKE_INSTALL_DATADIR}/graspdb)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/graspdb)

configure_package_config_file(cmake/graspdbConfig.cmake.in graspdbConfig.cmake
                              INSTALL_DESTINATION ${package_dir} PATH_VARS GRASPDB_DATA_DIR)
write_basic_package_version_file(graspdbConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/graspdbConfig.cmake ${PROJECT_BINARY_DIR}/graspdbConfigVersion.cmake
        DESTINATION ${package_dir} COMPONENT development)
install(EXPORT graspdb-runtime NAMESPACE graspdb:: DESTINATION ${package_dir} COMPONENT development)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
# Also without the program: HandReader finds hands with the one and describes them with the other.
install(DIRECTORY assets/descriptors assets/finders DESTINATION ${GRASPDB_DATA_DIR}/assets COMPONENT program)
if(GRASPDB_RUNTIME_ONLY)
  return()
endif()

install(EXPORT graspdb-full NAMESPACE graspdb:: DESTINATION ${package_dir} COMPONENT development)
install(DIRECTORY assets/hands assets/objects assets/presets DESTINATION ${GRASPDB_DATA_DIR}/assets COMPONENT program
        PATTERN "webxr_*.glb" EXCLUDE  # fetched, not ours to hand on
        PATTERN "*.py" EXCLUDE)
install(DIRECTORY grasps DESTINATION ${GRASPDB_DATA_DIR} COMPONENT program
        FILES_MATCHING PATTERN "*.toml" PATTERN include EXCLUDE)
install(DIRECTORY sequences/train sequences/test DESTINATION ${GRASPDB_DATA_DIR}/sequences COMPONENT program
        FILES_MATCHING PATTERN "*.toml" PATTERN "*.obj")
