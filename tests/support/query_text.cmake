# Queries and answers as text, for failing tests and for fuzz targets, which are also built without the tests.
# SPDX-License-Identifier: MIT
add_library(touchstone_query_text STATIC ${CMAKE_CURRENT_LIST_DIR}/query_text.cpp)
target_include_directories(touchstone_query_text PUBLIC ${PROJECT_SOURCE_DIR}/tests)
target_link_libraries(touchstone_query_text PUBLIC touchstone_whole PRIVATE touchstone_settings)
