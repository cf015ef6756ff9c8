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
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")  # it looks for unused memory less often: a tenth of the time to compile, up to 600 MB a file
    target_compile_options(${target} PRIVATE --param=ggc-min-expand=400 --param=ggc-min-heapsize=1000000)
  endif()
  if(LEONHARD_STRICT)
    target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion -Wno-missing-field-initializers -Werror)
    target_compile_definitions(${target} PRIVATE _GLIBCXX_ASSERTIONS)
  endif()
  if(LEONHARD_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${LEONHARD_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
    # The address sanitizer ends a program at what these find, and they take a third of the time to compile. The fuzz targets,
    # built with clang, keep the three that GCC is slow at.
    if(LEONHARD_SANITIZE MATCHES "address")
      target_compile_options(${target} PRIVATE -fno-sanitize=object-size,pointer-overflow)
    endif()
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND LEONHARD_SANITIZE MATCHES "address")
      target_compile_options(${target} PRIVATE -fno-sanitize=null,alignment,vptr)
      # Checks of addresses as calls, not written out at each place: a fifth of the time to compile. The rooms in which the
      # tests spend their time keep them inline.
      if(NOT target MATCHES "^leonhard_(kernel|delaunay|solver)$")
        target_compile_options(${target} PRIVATE --param=asan-instrumentation-with-call-threshold=0)
      endif()
    endif()
    target_link_options(${target} PRIVATE -fsanitize=${LEONHARD_SANITIZE})
  endif()
  if(LEONHARD_FUZZ)  # libFuzzer sees which branches of the libraries an input takes
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
endfunction()

# What the rooms and the program read of the standard library, compiled once for all of them: a seventh of the time to compile the
# release preset. Sources whose options do not agree with it read it themselves; so does all with
# CMAKE_DISABLE_PRECOMPILE_HEADERS, which shows that what the sources of a folder include is enough.
file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/standard_headers.cpp CONTENT "")
add_library(leonhard_standard_headers OBJECT EXCLUDE_FROM_ALL ${PROJECT_BINARY_DIR}/standard_headers.cpp)
leonhard_flags(leonhard_standard_headers)
set_target_properties(leonhard_standard_headers PROPERTIES POSITION_INDEPENDENT_CODE ON)
target_precompile_headers(leonhard_standard_headers PRIVATE <algorithm> <array> <bit> <charconv> <cmath> <compare> <cstddef> <cstdint>
  <filesystem> <functional> <iterator> <limits> <map> <memory> <numbers> <numeric> <optional> <set> <span> <stdexcept>
  <stop_token> <string> <string_view> <tuple> <type_traits> <utility> <variant> <vector>)
function(leonhard_precompiled target)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_precompile_headers(${target} REUSE_FROM leonhard_standard_headers)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_source_file_property(options ${source} TARGET_DIRECTORY ${target} COMPILE_OPTIONS)
    if(options MATCHES "-m|-O0")
      set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
    endif()
  endforeach()
endfunction()

# leonhard_unity(TARGET): compile the sources of a folder as one, eight at most, sixteen in release builds, which are made
# once: headers are read and templates compiled once for all of them. Names in a folder's unnamed namespaces must differ for it, but for those of meshes of the plane and
# of space: files of tetrahedra, by their names, are put together apart. Sources with options of their own, and those named
# SEPARATE, stay alone.
function(leonhard_unity target)
  if(NOT LEONHARD_UNITY)
    return()
  endif()
  cmake_parse_arguments(UNITY "" "" "SEPARATE" ${ARGN})
  get_target_property(sources ${target} SOURCES)
  get_target_property(directory ${target} SOURCE_DIR)
  list(TRANSFORM UNITY_SEPARATE PREPEND ${directory}/)
  set(folders "")
  foreach(source IN LISTS sources)
    if(NOT source MATCHES "\\.cpp$")
      continue()
    endif()
    get_filename_component(source ${source} ABSOLUTE BASE_DIR ${directory})
    get_source_file_property(options ${source} TARGET_DIRECTORY ${target} COMPILE_OPTIONS)
    get_source_file_property(definitions ${source} TARGET_DIRECTORY ${target} COMPILE_DEFINITIONS)
    if(source IN_LIST UNITY_SEPARATE OR options OR definitions)
      set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
      continue()
    endif()
    get_filename_component(folder ${source} DIRECTORY)
    get_filename_component(file ${source} NAME)
    if(file MATCHES "tet")
      string(APPEND folder /tet)
    endif()
    list(APPEND folders ${folder})
    list(APPEND sources_of_${folder} ${source})
  endforeach()
  list(REMOVE_DUPLICATES folders)
  set(most 8)
  if(CMAKE_BUILD_TYPE STREQUAL "Release")
    set(most 16)
  endif()
  foreach(folder IN LISTS folders)
    list(LENGTH sources_of_${folder} count)
    math(EXPR groups "(${count} + ${most} - 1) / ${most}")
    math(EXPR size "(${count} + ${groups} - 1) / ${groups}")
    file(RELATIVE_PATH name ${directory} ${folder})
    string(MAKE_C_IDENTIFIER "${name}" name)
    set(index 0)
    foreach(source IN LISTS sources_of_${folder})
      math(EXPR group "${index} / ${size}")
      math(EXPR index "${index} + 1")
      set_source_files_properties(${source} TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP "${name}_${group}")
    endforeach()
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

# leonhard_room(NAME SOURCES ... SEPARATE ...): the library target leonhard_NAME with its alias leonhard::NAME, a
# component of the package. Its sources are compiled folder by folder but for the separate ones (leonhard_unity).
function(leonhard_room name)
  cmake_parse_arguments(ROOM "" "" "SOURCES;SEPARATE" ${ARGN})
  add_library(leonhard_${name} ${ROOM_SOURCES})
  add_library(leonhard::${name} ALIAS leonhard_${name})
  leonhard_flags(leonhard_${name})
  target_include_directories(leonhard_${name} PUBLIC $<BUILD_INTERFACE:${LEONHARD_BUILD_INCLUDE}>)
  # Static and shared libraries are made of the same objects.
  set_target_properties(leonhard_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON DEFINE_SYMBOL ""
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR} INSTALL_RPATH $ORIGIN)
  if(NOT PROJECT_IS_TOP_LEVEL AND NOT LEONHARD_INSTALL)  # another project builds what it links
    set_target_properties(leonhard_${name} PROPERTIES EXCLUDE_FROM_ALL ON)
  endif()
  set_property(GLOBAL APPEND PROPERTY LEONHARD_COMPONENTS ${name})
  # At the end of the room's folder, when all its sources are known.
  cmake_language(EVAL CODE "cmake_language(DEFER CALL leonhard_unity leonhard_${name} SEPARATE ${ROOM_SEPARATE})
    cmake_language(DEFER CALL leonhard_precompiled leonhard_${name})")
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

# Most of what a test compiles to runs once: compiling it takes 0.6 of the time of -O1. Of values that may not be set GCC 12
# then tells falsely.
set(LEONHARD_TEST_OPTIONS "$<IF:$<CXX_COMPILER_ID:GNU>,-Og;-Wno-maybe-uninitialized,-O0>")

# leonhard_test(ROOM SOURCES ... LIBRARIES ...): one doctest program a room; each test case is one ctest entry. What doctest and
# the standard library declare is compiled once for all of them.
function(leonhard_test room)
  cmake_parse_arguments(TEST "" "" "SOURCES;LIBRARIES" ${ARGN})
  add_executable(test_${room} ${TEST_SOURCES} $<TARGET_OBJECTS:leonhard_test_main>)
  leonhard_flags(test_${room})
  target_include_directories(test_${room} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(test_${room} PRIVATE ${TEST_LIBRARIES} doctest::doctest)
  target_compile_options(test_${room} PRIVATE ${LEONHARD_TEST_OPTIONS})
  target_precompile_headers(test_${room} REUSE_FROM leonhard_test_main)
  doctest_discover_tests(test_${room} TEST_PREFIX "${room}: " PROPERTIES LABELS ${room})
endfunction()
