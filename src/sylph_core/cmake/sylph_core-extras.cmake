# Warnings of the suite, as private options: they never reach who links against a target.
function(sylph_set_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
endfunction()

# A gtest under catkin (run_tests) as well as under plain CMake (ctest).
function(sylph_add_gtest target)
  if(catkin_FOUND)
    if(NOT CATKIN_ENABLE_TESTING)
      return()
    endif()
    find_package(GTest REQUIRED)
    catkin_add_gtest(${target} ${ARGN} WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
    target_link_libraries(${target} GTest::gtest_main)  # Debian's catkin links gtest alone
  else()
    if(NOT BUILD_TESTING)
      return()
    endif()
    find_package(GTest REQUIRED)
    add_executable(${target} ${ARGN})
    target_link_libraries(${target} GTest::gtest GTest::gtest_main)
    add_test(NAME ${target} COMMAND ${target} WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR})
  endif()
  target_link_libraries(${target} ${PROJECT_NAME})
  target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})  # "test/support/..."
  sylph_set_warnings(${target})
endfunction()
