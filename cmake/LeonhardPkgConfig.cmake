# SPDX-License-Identifier: MIT
# pkg-config: leonhard-ROOM for each room, leonhard for all. What a shared library links is its own affair (.private); who links
# a static one has to link that too.

# How pkg-config calls a CMake package: a module, a flag, or nothing where headers alone are used.
set(pkg_config_module_Boost "")
set(pkg_config_module_GMP gmpxx)
set(pkg_config_module_TBB tbb)
set(pkg_config_module_ZLIB zlib)
set(pkg_config_flag_METIS -lmetis)
set(pkg_config_flag_SCOTCH "-lscotch -lscotcherr")

set(pkg_config_dir ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
string(REGEX REPLACE "[^/]+" ".." prefix_from_pkg_config ${pkg_config_dir})

function(leonhard_pkg_config name description)
  cmake_parse_arguments(PC "" "LIBS;CFLAGS" "REQUIRES;REQUIRES_PRIVATE;LIBS_PRIVATE" ${ARGN})
  list(JOIN PC_REQUIRES ", " requires)
  list(JOIN PC_REQUIRES_PRIVATE ", " requires_private)
  list(JOIN PC_LIBS_PRIVATE " " libs_private)
  file(WRITE ${PROJECT_BINARY_DIR}/${name}.pc
"prefix=\${pcfiledir}/${prefix_from_pkg_config}
libdir=\${prefix}/${CMAKE_INSTALL_LIBDIR}
includedir=\${prefix}/${CMAKE_INSTALL_INCLUDEDIR}

Name: ${name}
Description: ${description}
URL: ${PROJECT_HOMEPAGE_URL}
Version: ${PROJECT_VERSION}
Requires: ${requires}
Requires.private: ${requires_private}
Cflags: ${PC_CFLAGS}
Libs: ${PC_LIBS}
Libs.private: ${libs_private}
")
  install(FILES ${PROJECT_BINARY_DIR}/${name}.pc DESTINATION ${pkg_config_dir} COMPONENT development)
endfunction()

set(all_modules "")
foreach(component ${components})
  foreach(kind COMPONENTS PACKAGES LINKED_PACKAGES LINKED_MODULES)
    get_property(${kind} GLOBAL PROPERTY LEONHARD_${kind}_OF_${component})
  endforeach()
  set(requires "")
  set(linked "")
  set(linked_flags "")
  foreach(needed ${COMPONENTS})
    list(APPEND requires leonhard-${needed})
  endforeach()
  foreach(package ${PACKAGES})
    list(APPEND requires ${pkg_config_module_${package}})
  endforeach()
  foreach(package ${LINKED_PACKAGES})
    list(APPEND linked ${pkg_config_module_${package}})
    list(APPEND linked_flags ${pkg_config_flag_${package}})
  endforeach()
  foreach(module ${LINKED_MODULES})
    string(REGEX REPLACE ".*=" "" module ${module})
    list(APPEND linked ${module})
  endforeach()

  get_target_property(definitions leonhard_${component} INTERFACE_COMPILE_DEFINITIONS)
  set(cflags "-I\${includedir}")
  if(definitions)
    foreach(definition ${definitions})
      string(APPEND cflags " -D${definition}")
    endforeach()
  endif()
  set(libs "-L\${libdir} -lleonhard_${component}")
  if(shared)
    leonhard_pkg_config(leonhard-${component} "Leonhard's room ${component}; C++20" REQUIRES ${requires} CFLAGS ${cflags}
      LIBS ${libs} REQUIRES_PRIVATE ${linked} LIBS_PRIVATE ${linked_flags})
  else()
    list(JOIN linked_flags " " linked_flags)
    leonhard_pkg_config(leonhard-${component} "Leonhard's room ${component}; C++20" REQUIRES ${requires} ${linked} CFLAGS ${cflags}
      LIBS "${libs} ${linked_flags}")
  endif()
  list(APPEND all_modules leonhard-${component})
endforeach()
leonhard_pkg_config(leonhard "${PROJECT_DESCRIPTION}; C++20" REQUIRES ${all_modules})
