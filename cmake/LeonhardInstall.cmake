# SPDX-License-Identifier: MIT
# What is installed: the program; the libraries with the headers that users may include; and how users find them,
# find_package(leonhard CONFIG COMPONENTS ...) and pkg-config leonhard-ROOM.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
include(cmake/LeonhardHeaders.cmake)

get_property(components GLOBAL PROPERTY LEONHARD_COMPONENTS)
get_target_property(kind leonhard_kernel TYPE)
string(COMPARE EQUAL ${kind} SHARED_LIBRARY shared)
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/leonhard)

# Libraries: an export set each, so that each is found with its own dependencies alone.
foreach(component ${components})
  install(TARGETS leonhard_${component} EXPORT leonhard_${component}
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT libraries NAMELINK_COMPONENT development
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(EXPORT leonhard_${component} NAMESPACE leonhard:: FILE leonhard-${component}.cmake DESTINATION ${config_dir}
    COMPONENT development)
endforeach()

# Headers: which ones is seen when they are installed, so that it is never out of date.
set(header_folders kernel mesh mesh/io delaunay graph)
if(LEONHARD_DRAW)
  list(APPEND header_folders mesh/draw)
endif()
if(LEONHARD_SOLVER)
  list(APPEND header_folders solver)
endif()
install(CODE "
  set(LEONHARD_METIS ${LEONHARD_METIS})
  set(LEONHARD_SCOTCH ${LEONHARD_SCOTCH})
  include([[${PROJECT_SOURCE_DIR}/cmake/LeonhardHeaders.cmake]])
  leonhard_public_headers(public [[${PROJECT_SOURCE_DIR}]] ${header_folders})
  leonhard_header_closure(headers [[${PROJECT_SOURCE_DIR}]] \${public})
  foreach(header \${headers})
    get_filename_component(folder \${header} DIRECTORY)
    file(INSTALL \"${PROJECT_SOURCE_DIR}/\${header}\"
      DESTINATION \"\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_INCLUDEDIR}/leonhard/\${folder}\")
  endforeach()" COMPONENT development)

# find_package: a table of what each component needs, and the functions that read it.
set(component_table "")
foreach(component ${components})
  foreach(kind COMPONENTS PACKAGES LINKED_PACKAGES LINKED_MODULES)
    get_property(${kind} GLOBAL PROPERTY LEONHARD_${kind}_OF_${component})
  endforeach()
  if(NOT shared)
    list(APPEND PACKAGES ${LINKED_PACKAGES})
    set(modules ${LINKED_MODULES})
  else()
    set(modules "")
  endif()
  string(APPEND component_table "set(_leonhard_components_of_${component} ${COMPONENTS})\n"
    "set(_leonhard_packages_of_${component} ${PACKAGES})\nset(_leonhard_modules_of_${component} ${modules})\n")
endforeach()
configure_package_config_file(cmake/leonhardConfig.cmake.in ${PROJECT_BINARY_DIR}/leonhardConfig.cmake
  INSTALL_DESTINATION ${config_dir} NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/leonhardConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/leonhardConfig.cmake ${PROJECT_BINARY_DIR}/leonhardConfigVersion.cmake
  cmake/FindGMP.cmake cmake/FindMETIS.cmake cmake/FindSCOTCH.cmake DESTINATION ${config_dir} COMPONENT development)

include(cmake/LeonhardPkgConfig.cmake)

if(LEONHARD_APP)
  if(shared)
    file(RELATIVE_PATH libraries_from_program /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_LIBDIR})
    set_target_properties(leonhard_program PROPERTIES INSTALL_RPATH $ORIGIN/${libraries_from_program})
  endif()
  install(TARGETS leonhard_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
endif()

if(PROJECT_IS_TOP_LEVEL)
  include(cmake/LeonhardPackage.cmake)
endif()
