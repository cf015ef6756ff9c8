# SPDX-License-Identifier: MIT
# Which headers users get. What lies at the root of a room is public; of the sub-folders only that which a public header
# includes, directly or not, is installed with it.

cmake_policy(VERSION 3.25)  # also read by scripts

# leonhard_public_headers(OUT SOURCE FOLDERS...): the headers at the root of each folder, relative to SOURCE. The doors to other
# partitioners count only where LEONHARD_METIS and LEONHARD_SCOTCH are set.
function(leonhard_public_headers out source)
  set(public "")
  foreach(folder ${ARGN})
    file(GLOB headers RELATIVE ${source} ${source}/${folder}/*.hpp)
    list(APPEND public ${headers})
  endforeach()
  if(NOT LEONHARD_METIS)
    list(REMOVE_ITEM public graph/metis.hpp)
  endif()
  if(NOT LEONHARD_SCOTCH)
    list(REMOVE_ITEM public graph/scotch.hpp)
  endif()
  set(${out} ${public} PARENT_SCOPE)
endfunction()

# leonhard_header_closure(OUT SOURCE HEADERS...): these headers and all of the project that they include.
function(leonhard_header_closure out source)
  set(waiting ${ARGN})
  set(closure "")
  while(waiting)
    list(POP_FRONT waiting header)
    if(header IN_LIST closure)
      continue()
    endif()
    list(APPEND closure ${header})
    file(STRINGS ${source}/${header} includes REGEX "^ *# *include +[\"<]leonhard/")
    foreach(include ${includes})
      string(REGEX REPLACE "^ *# *include +[\"<]leonhard/([^\">]+)[\">].*" "\\1" included "${include}")
      if(NOT EXISTS ${source}/${included})
        message(FATAL_ERROR "${header} includes leonhard/${included}, which is not there")
      endif()
      list(APPEND waiting ${included})
    endforeach()
  endwhile()
  list(SORT closure)
  set(${out} ${closure} PARENT_SCOPE)
endfunction()
