# SPDX-License-Identifier: MIT
# Manual pages and completions, made from the program's help; and what cpack makes of the build tree: Debian packages
#   leonhard         the program, its manual pages and completions
#   libleonhard0.1   shared libraries, where they are
#   libleonhard-dev  headers, static libraries or links to shared ones, CMake and pkg-config files

if(LEONHARD_APP)
  if(NOT CMAKE_CROSSCOMPILING)
    set(manual ${PROJECT_BINARY_DIR}/manual)
    add_custom_command(OUTPUT ${manual}/man1/leonhard.1
      COMMAND ${PROJECT_SOURCE_DIR}/cmake/manual.sh $<TARGET_FILE:leonhard_program> ${manual}
      DEPENDS leonhard_program cmake/manual.sh WORKING_DIRECTORY ${PROJECT_SOURCE_DIR} VERBATIM
      COMMENT "Making the manual from the program's help")
    add_custom_target(leonhard_manual ALL DEPENDS ${manual}/man1/leonhard.1)
    # Optional: who built the program alone (./leonhard) can install it, without them.
    install(DIRECTORY ${manual}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT program OPTIONAL)
    install(FILES ${manual}/bash/leonhard DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program OPTIONAL)
    set(zsh_folder site-functions)
    if(CMAKE_INSTALL_PREFIX STREQUAL /usr)  # Debian's own
      set(zsh_folder vendor-completions)
    endif()
    install(FILES ${manual}/zsh/_leonhard DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/${zsh_folder} COMPONENT program OPTIONAL)
  endif()
  install(DIRECTORY examples/naca0012 examples/rae2822 examples/highlift examples/wedge examples/ball
    DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples COMPONENT program)
endif()
install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
install(DIRECTORY docs/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs COMPONENT development FILES_MATCHING PATTERN "*.md")
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR}/docs COMPONENT development)

set(CPACK_PACKAGE_NAME leonhard)
set(CPACK_PACKAGE_VENDOR "Leonhard's authors")
set(CPACK_PACKAGE_CONTACT "Leonhard's authors <leonhard@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY ${PROJECT_DESCRIPTION})
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX ${CMAKE_INSTALL_PREFIX})
set(CPACK_STRIP_FILES ON)
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_COMPONENTS_ALL development)

# The program.
if(LEONHARD_APP)
  list(APPEND CPACK_COMPONENTS_ALL program)
endif()
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "Exact Delaunay meshing, mesh graphs and finite volumes: the program")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME leonhard)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS fonts-dejavu-core)

# The library, for those who write programs. Static libraries need what they were linked with as soon as they are linked; the large
# dependencies of pictures and of the solver are left to those who use these.
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "Exact Delaunay meshing, mesh graphs and finite volumes: the C++ library")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libleonhard-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(development_depends libboost-dev libgmp-dev)
set(development_suggests "")
if(LEONHARD_COMPRESSION AND NOT shared)
  list(APPEND development_depends zlib1g-dev)
  foreach(module lz4 lzma)
    string(TOUPPER ${module} MODULE)
    if(TARGET PkgConfig::LEONHARD_${MODULE})
      list(APPEND development_depends lib${module}-dev)
    endif()
  endforeach()
endif()
if(LEONHARD_THREADS AND NOT shared)
  list(APPEND development_depends libtbb-dev)
endif()
if(NOT shared)
  if(LEONHARD_DRAW)
    list(APPEND development_suggests libcairo2-dev)
  endif()
  if(LEONHARD_SOLVER)
    list(APPEND development_suggests libpetsc-real-dev)
  endif()
  if(LEONHARD_METIS)
    list(APPEND development_suggests libmetis-dev)
  endif()
  if(LEONHARD_SCOTCH)
    list(APPEND development_suggests libscotch-dev)
  endif()
endif()
list(APPEND development_suggests cmake pkg-config)

if(shared)
  set(runtime libleonhard${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  list(APPEND CPACK_COMPONENTS_ALL libraries)
  set(CPACK_COMPONENT_LIBRARIES_DESCRIPTION "Exact Delaunay meshing, mesh graphs and finite volumes: shared libraries")
  set(CPACK_DEBIAN_LIBRARIES_PACKAGE_NAME ${runtime})
  set(CPACK_DEBIAN_LIBRARIES_PACKAGE_SECTION libs)
  set(CPACK_DEBIAN_LIBRARIES_PACKAGE_SHLIBDEPS ON)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/kernel ${PROJECT_BINARY_DIR}/mesh
    ${PROJECT_BINARY_DIR}/mesh/draw ${PROJECT_BINARY_DIR}/delaunay ${PROJECT_BINARY_DIR}/graph ${PROJECT_BINARY_DIR}/solver)
  list(APPEND development_depends "${runtime} (= ${PROJECT_VERSION})")
  set(CPACK_DEBIAN_PROGRAM_PACKAGE_DEPENDS "${runtime} (= ${PROJECT_VERSION})")
endif()
list(JOIN development_depends ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
list(JOIN development_suggests ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SUGGESTS)

include(CPack)
