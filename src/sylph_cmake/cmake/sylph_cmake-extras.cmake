# What the packages of the suite share in their CMake files, with catkin and without.

# C++17 by the letter, and a release build unless another one is asked for. Without catkin also a shared library
# unless BUILD_SHARED_LIBS is OFF, and tests unless BUILD_TESTING is.
macro(sylph_project_defaults)
  set(CMAKE_CXX_STANDARD 17)
  set(CMAKE_CXX_STANDARD_REQUIRED ON)
  set(CMAKE_CXX_EXTENSIONS OFF)  # writes -std=c++17 out, which clang-tidy needs
  if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
  endif()
  # Log statements name their source as <package>/src/..., wherever it was built.
  get_filename_component(sylph_source_space ${CMAKE_CURRENT_SOURCE_DIR} DIRECTORY)
  add_compile_options(-ffile-prefix-map=${sylph_source_space}/=)
  if(NOT catkin_FOUND)
    option(BUILD_SHARED_LIBS "build a shared library" ON)
    include(CTest)
    option(SYLPH_FUZZERS "build the fuzzers; needs clang" OFF)
    if(SYLPH_FUZZERS)
      add_compile_options(-O1 -gline-tables-only -fno-omit-frame-pointer -D_GLIBCXX_ASSERTIONS
        -fsanitize=fuzzer-no-link,address,undefined,float-cast-overflow -fno-sanitize-recover=all)
      add_link_options(-fsanitize=address,undefined)
    endif()
  endif()
endmacro()

# Warnings of the suite, as private options: they never reach who links against a target.
function(sylph_set_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wpedantic -Wshadow -Wconversion)
endfunction()

# With -O1 and with gtest's header precompiled, a test's source compiles in 3.2 s of processor time instead of 5.7.
# What tests call is in libraries, which keep -O3.
function(sylph_build_test_quickly target)
  target_compile_options(${target} PRIVATE -O1)
  get_target_property(sources ${target} SOURCES)
  list(LENGTH sources count)
  if(count GREATER 1)
    target_precompile_headers(${target} PRIVATE <gtest/gtest.h>)
  endif()
endfunction()

# A gtest under catkin (run_tests) as well as under plain CMake (ctest):
#   sylph_add_gtest(TARGET SOURCE...)
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
  sylph_build_test_quickly(${target})
endfunction()

# A gtest that needs a ROS master, with the library of its package; after find_package(rostest):
#   sylph_add_rostest_gtest(TARGET FILE.test SOURCE...)
function(sylph_add_rostest_gtest target)
  add_rostest_gtest(${target} ${ARGN})
  target_link_libraries(${target} ${PROJECT_NAME} ${catkin_LIBRARIES})
  sylph_set_warnings(${target})
  sylph_build_test_quickly(${target})
endfunction()

# Fuzzers fuzz/<name>_fuzzer.cpp, under plain CMake with -DSYLPH_FUZZERS=ON, as scripts/fuzz has it:
#   sylph_add_fuzzers(LIBRARY NAME...)
function(sylph_add_fuzzers library)
  if(catkin_FOUND OR NOT SYLPH_FUZZERS)
    return()
  endif()
  foreach(name IN LISTS ARGN)
    add_executable(${name}_fuzzer fuzz/${name}_fuzzer.cpp)
    target_link_libraries(${name}_fuzzer ${library} -fsanitize=fuzzer)
    target_include_directories(${name}_fuzzer PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})  # "fuzz/..."
    sylph_set_warnings(${name}_fuzzer)
  endforeach()
endfunction()

# The version in the package.xml of this folder.
function(sylph_package_version variable)
  file(STRINGS ${CMAKE_CURRENT_SOURCE_DIR}/package.xml line REGEX "<version>")
  string(REGEX REPLACE ".*<version>(.*)</version>.*" "\\1" version "${line}")
  set(${variable} ${version} PARENT_SCOPE)
endfunction()

# Installs the library ${PROJECT_NAME} and its headers for plain CMake, where find_package() then knows the
# target sylph::${PROJECT_NAME} and its version:
#   sylph_install_library(PUBLIC_PACKAGES "Eigen3" ... PRIVATE_PACKAGES "OpenCV COMPONENTS core" ...)
# Each is an argument list of find_dependency(): the public ones are in the headers, of the private ones a
# user knows nothing unless the library is static. Folders of headers in HEADERS_LEFT_OUT stay behind.
function(sylph_install_library)
  cmake_parse_arguments(arg "" "" "PUBLIC_PACKAGES;PRIVATE_PACKAGES;HEADERS_LEFT_OUT" ${ARGN})
  include(CMakePackageConfigHelpers)
  include(GNUInstallDirs)
  set(folder ${CMAKE_INSTALL_LIBDIR}/cmake/${PROJECT_NAME})
  set(packages ${arg_PUBLIC_PACKAGES})
  get_target_property(type ${PROJECT_NAME} TYPE)
  if(type STREQUAL "STATIC_LIBRARY")
    list(APPEND packages ${arg_PRIVATE_PACKAGES})
  endif()
  set(config "include(CMakeFindDependencyMacro)\n")
  foreach(package IN LISTS packages)
    string(APPEND config "find_dependency(${package})\n")
  endforeach()
  string(APPEND config "include(\${CMAKE_CURRENT_LIST_DIR}/${PROJECT_NAME}-targets.cmake)\n")
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/${PROJECT_NAME}-config.cmake "${config}")
  sylph_package_version(version)
  write_basic_package_version_file(
    ${CMAKE_CURRENT_BINARY_DIR}/${PROJECT_NAME}-config-version.cmake
    VERSION ${version} COMPATIBILITY SameMinorVersion)

  install(TARGETS ${PROJECT_NAME} EXPORT ${PROJECT_NAME}-targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  set(left_out "")
  foreach(headers IN LISTS arg_HEADERS_LEFT_OUT)
    list(APPEND left_out PATTERN ${headers} EXCLUDE)
  endforeach()
  install(DIRECTORY include/${PROJECT_NAME} DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} ${left_out})
  install(EXPORT ${PROJECT_NAME}-targets NAMESPACE sylph:: DESTINATION ${folder})
  install(FILES
    ${CMAKE_CURRENT_BINARY_DIR}/${PROJECT_NAME}-config.cmake
    ${CMAKE_CURRENT_BINARY_DIR}/${PROJECT_NAME}-config-version.cmake
    DESTINATION ${folder})
endfunction()
