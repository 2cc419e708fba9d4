# Every shaders/*.comp becomes SPIR-V in a C header of the build tree, once per way of fetching tree and primitive data:
# *_texel (image loads: fast on lavapipe) and *_storage (storage buffers: what hardware prefers).
file(GLOB kernel_sources CONFIGURE_DEPENDS shaders/*.comp)
file(GLOB_RECURSE shader_includes CONFIGURE_DEPENDS shaders/*.glsl shaders/*.h)
set(spirv_dir ${PROJECT_BINARY_DIR}/spirv)
file(MAKE_DIRECTORY ${spirv_dir}/spirv)
set(spirv_headers)
foreach(source ${kernel_sources})
  get_filename_component(kernel ${source} NAME_WE)
  foreach(fetch texel storage)
    string(TOUPPER ${fetch} fetch_upper)
    set(header ${spirv_dir}/spirv/${kernel}_${fetch}.h)
    add_custom_command(
      OUTPUT ${header}
      COMMAND ${GLSLANG_VALIDATOR} -V --target-env vulkan1.2 --quiet -DFETCH_${fetch_upper}
              -I${PROJECT_SOURCE_DIR}/shaders --vn k_${kernel}_${fetch}_spirv -o ${header} ${source}
      DEPENDS ${source} ${shader_includes}
      COMMENT "SPIR-V ${kernel} (${fetch})"
      VERBATIM)
    list(APPEND spirv_headers ${header})
  endforeach()
endforeach()
add_custom_target(capcon_spirv DEPENDS ${spirv_headers})
add_library(capcon_shaders INTERFACE)
target_include_directories(capcon_shaders INTERFACE ${spirv_dir})
add_dependencies(capcon_shaders capcon_spirv)
