# Where CMAKE_UNITY_BUILD is on (every preset but apart), sources of one folder are compiled several at a time, as one file: their shared
# headers are read once for all of them. Only sources of one folder meet, so that a name inside a file must be its own within
# its room and no further. Called from the folder that makes the target; why: docs/decisions/code/0002-unity-builds.md.
set(TRILITH_TOGETHER 12 CACHE STRING "Sources of one folder that are compiled as one file where CMAKE_UNITY_BUILD is on")

function(compile_together target)
  if(NOT CMAKE_UNITY_BUILD)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_source_file_property(alone ${source} SKIP_UNITY_BUILD_INCLUSION)
    if(alone OR source MATCHES "^${PROJECT_BINARY_DIR}/")
      continue()
    endif()
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR})
    string(MAKE_C_IDENTIFIER "${folder}" room)
    if(NOT DEFINED met_${room})
      set(met_${room} 0)
    endif()
    math(EXPR batch "${met_${room}} / ${TRILITH_TOGETHER}")
    math(EXPR met_${room} "${met_${room}} + 1")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${room}_${batch})
  endforeach()
endfunction()

# For code that no time step calls.
function(optimise_less target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()
