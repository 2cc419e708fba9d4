# The checks of the fuzzers' targets, with the libraries of the normal build.
file(GLOB fuzz_checks CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/*_targets.cpp)
list(APPEND fuzz_checks ${CMAKE_CURRENT_LIST_DIR}/target.cpp ${CMAKE_CURRENT_LIST_DIR}/files.cpp
     ${CMAKE_CURRENT_LIST_DIR}/scene_check.cpp)
add_library(capcon_fuzz_checks STATIC ${fuzz_checks})
target_include_directories(capcon_fuzz_checks PUBLIC ${CMAKE_CURRENT_LIST_DIR}/..)
target_compile_options(capcon_fuzz_checks PRIVATE -O1)
target_link_libraries(capcon_fuzz_checks PUBLIC capcon_study capcon_serve)
set(links capcon_fuzz_checks)
