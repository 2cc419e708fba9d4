# The shipped scenes' geometry is written by our own generator at build time into scenes/geometry (not tracked).
file(GLOB generator_sources CONFIGURE_DEPENDS scenes/generator/*.cpp)
list(FILTER generator_sources EXCLUDE REGEX "/main\\.cpp$")
add_library(capcon_scenes STATIC ${generator_sources})
target_include_directories(capcon_scenes PUBLIC scenes)
target_link_libraries(capcon_scenes PUBLIC capcon_image capcon_base)
target_compile_options(capcon_scenes PRIVATE -O1)  # seconds of work, compiled in half the time
add_executable(capcon_scenes_program scenes/generator/main.cpp)
set_target_properties(capcon_scenes_program PROPERTIES OUTPUT_NAME capcon_scenes)
target_link_libraries(capcon_scenes_program PRIVATE capcon_scenes)
# The stamp lies in the build tree: the generator runs again when it has changed, and once for every build tree.
set(geometry_stamp ${PROJECT_BINARY_DIR}/geometry.stamp)
add_custom_command(
  OUTPUT ${geometry_stamp}
  COMMAND capcon_scenes_program ${PROJECT_SOURCE_DIR}/scenes/geometry
  COMMAND ${CMAKE_COMMAND} -E touch ${geometry_stamp}
  DEPENDS capcon_scenes_program
  COMMENT "Geometry of the shipped scenes"
  VERBATIM)
add_custom_target(capcon_geometry ALL DEPENDS ${geometry_stamp})
