# What all packages of the train energy simulator build with. rail_core includes this file itself, the others get it with
# find_package(catkin COMPONENTS rail_core); the plain build without ROS includes it from the root CMakeLists.txt.
#
#   rail_compile_options(target)               language, warnings, arithmetic
#   rail_link(target package...)               links libraries of other packages of this project, in every kind of build
#   rail_add_gtest(name source... [LIBRARIES library...])   nothing happens if tests are disabled
#
# Targets of all packages share one name space (catkin_make): begin test names with the package's name.

#catkin_lint: ignore global_var_collision
option(TRAIN_WITHOUT_ROS "Build the physics libraries with plain CMake" OFF)
option(TRAIN_WARNINGS_AS_ERRORS "Treat compiler warnings as errors" OFF)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
endif()
#catkin_lint: report global_var_collision

# No -ffast-math and no -march=native: results must be the same bits on every machine of a processor family;
# -ffp-contract=off for the same reason. -O2 follows, and so replaces, the -O3 of CMake's Release.
function(rail_compile_options target)
  set_target_properties(${target} PROPERTIES CXX_STANDARD 17 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -ffp-contract=off
    $<$<CONFIG:Release>:-O2> $<$<BOOL:${TRAIN_WARNINGS_AS_ERRORS}>:-Werror>)
endfunction()

# A package that is built in the same CMake run is a target; otherwise (colcon, an installed package) it is what
# find_package(catkin COMPONENTS package) found.
function(rail_link target)
  foreach(package ${ARGN})
    if(TARGET ${package})
      target_link_libraries(${target} PUBLIC ${package})
    elseif(${package}_FOUND)
      target_include_directories(${target} PUBLIC ${${package}_INCLUDE_DIRS})
      target_link_libraries(${target} PUBLIC ${${package}_LIBRARIES})
    else()
      message(FATAL_ERROR "rail_link(${target} ${package}): no such target, nor found by find_package(catkin)")
    endif()
  endforeach()
endfunction()

# TEST_DATA_DIR is the directory `test` of the package, as a C++ string literal.
function(rail_add_gtest name)
  cmake_parse_arguments(arg "" "" "LIBRARIES" ${ARGN})
  if(TRAIN_WITHOUT_ROS)
    if(NOT BUILD_TESTING)
      return()
    endif()
    find_package(GTest REQUIRED)
    add_executable(${name} ${arg_UNPARSED_ARGUMENTS})
    add_test(NAME ${name} COMMAND ${name})
  else()
    if(NOT CATKIN_ENABLE_TESTING)
      return()
    endif()
    catkin_add_gtest(${name} ${arg_UNPARSED_ARGUMENTS})
  endif()
  if(NOT TARGET ${name})
    return()  # catkin has no gtest and has said so
  endif()
  if(TARGET GTest::gtest_main)
    set(gtest_main GTest::gtest_main)
  elseif(TARGET GTest::Main)
    set(gtest_main GTest::Main)  # CMake's own FindGTest before 3.20
  else()
    set(gtest_main gtest_main)  # catkin builds it from source (Ubuntu 20.04)
  endif()
  # No PUBLIC or PRIVATE: catkin_add_gtest has used the plain form, and the two do not mix.
  target_link_libraries(${name} ${arg_LIBRARIES} ${gtest_main})
  target_compile_definitions(${name} PRIVATE TEST_DATA_DIR="${CMAKE_CURRENT_SOURCE_DIR}/test")
  rail_compile_options(${name})
endfunction()
