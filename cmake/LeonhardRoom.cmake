# SPDX-License-Identifier: MIT
# How every room of the house is built: one target a room, flags on targets only.

# Headers are read as <leonhard/ROOM/FILE.hpp> in the build tree and after installation alike: the build tree
# holds a folder of links to the rooms.
set(LEONHARD_BUILD_INCLUDE ${PROJECT_BINARY_DIR}/include)
file(MAKE_DIRECTORY ${LEONHARD_BUILD_INCLUDE}/leonhard)
foreach(room kernel mesh delaunay graph solver app)
  if(NOT EXISTS ${LEONHARD_BUILD_INCLUDE}/leonhard/${room})
    file(CREATE_LINK ${PROJECT_SOURCE_DIR}/${room} ${LEONHARD_BUILD_INCLUDE}/leonhard/${room} SYMBOLIC)
  endif()
endforeach()

# leonhard_flags(TARGET): language level, no contraction of a*b+c (exactness rests on it), sanitizers; warnings, all
# errors, in strict builds only: GCC 12 has false ones at -O3, and whoever builds to use cannot do anything about them.
function(leonhard_flags target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE -ffp-contract=off)
  if(LEONHARD_STRICT)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wno-missing-field-initializers -Werror)
    target_compile_definitions(${target} PRIVATE _GLIBCXX_ASSERTIONS)
  endif()
  if(LEONHARD_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${LEONHARD_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PRIVATE -fsanitize=${LEONHARD_SANITIZE})
  endif()
  if(LEONHARD_FUZZ)  # libFuzzer sees which branches of the libraries an input takes
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
endfunction()

# leonhard_room(NAME SOURCES ...): the library target leonhard_NAME with its alias leonhard::NAME, a component of the package.
function(leonhard_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES" ${ARGN})
  add_library(leonhard_${name} ${ROOM_SOURCES})
  add_library(leonhard::${name} ALIAS leonhard_${name})
  leonhard_flags(leonhard_${name})
  target_include_directories(leonhard_${name} PUBLIC $<BUILD_INTERFACE:${LEONHARD_BUILD_INCLUDE}>)
  set_target_properties(leonhard_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} INSTALL_RPATH $ORIGIN)
  if(NOT PROJECT_IS_TOP_LEVEL AND NOT LEONHARD_INSTALL)  # another project builds what it links
    set_target_properties(leonhard_${name} PROPERTIES EXCLUDE_FROM_ALL ON)
  endif()
  set_property(GLOBAL APPEND PROPERTY LEONHARD_COMPONENTS ${name})
endfunction()

# leonhard_needs(NAME COMPONENTS ... PACKAGES ... LINKED_PACKAGES ... LINKED_MODULES ...): what users of an installed room have to
# find: other rooms; packages of which its headers speak; packages and pkg-config modules (as PREFIX=module) that are linked into
# it, for which only users of a static library have to look.
function(leonhard_needs name)
  cmake_parse_arguments(NEEDS "" "" "COMPONENTS;PACKAGES;LINKED_PACKAGES;LINKED_MODULES" ${ARGN})
  foreach(kind COMPONENTS PACKAGES LINKED_PACKAGES LINKED_MODULES)
    set_property(GLOBAL APPEND PROPERTY LEONHARD_${kind}_OF_${name} ${NEEDS_${kind}})
  endforeach()
endfunction()

# leonhard_test(ROOM SOURCES ... LIBRARIES ...): one doctest program a room; each test case is one ctest entry.
function(leonhard_test room)
  cmake_parse_arguments(TEST "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(test_${room} ${TEST_SOURCES} $<TARGET_OBJECTS:leonhard_test_main>)
  leonhard_flags(test_${room})
  target_include_directories(test_${room} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(test_${room} PRIVATE ${TEST_LIBRARIES} doctest::doctest)
  doctest_discover_tests(test_${room} TEST_PREFIX "${room}: " PROPERTIES LABELS ${room})
endfunction()
