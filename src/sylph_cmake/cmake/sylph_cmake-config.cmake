# For find_package(sylph_cmake) without catkin, installed or in the source tree.
include(${CMAKE_CURRENT_LIST_DIR}/sylph_cmake-extras.cmake)
