# SPDX-License-Identifier: MIT
# find_package(leonhard CONFIG) gives leonhard::kernel, leonhard::mesh, ... as built.
include(CMakePackageConfigHelpers)

get_property(room_targets GLOBAL PROPERTY LEONHARD_ROOM_TARGETS)
install(TARGETS ${room_targets} EXPORT leonhardTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
foreach(room kernel mesh delaunay graph solver)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${room}/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/leonhard/${room}
    FILES_MATCHING PATTERN "*.hpp")
endforeach()
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/leonhard)
install(EXPORT leonhardTargets NAMESPACE leonhard:: DESTINATION ${config_dir})
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/leonhardConfig.cmake.in
  ${PROJECT_BINARY_DIR}/leonhardConfig.cmake INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/leonhardConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/leonhardConfig.cmake ${PROJECT_BINARY_DIR}/leonhardConfigVersion.cmake
  ${PROJECT_SOURCE_DIR}/cmake/FindGMP.cmake DESTINATION ${config_dir})
