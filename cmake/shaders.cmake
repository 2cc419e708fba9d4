# A kernel.comp becomes SPIR-V in C headers of the build tree, once per way of fetching tree and primitive data: spirv/kernel_texel.h
# (image loads: fast on lavapipe) and spirv/kernel_storage.h (storage buffers: what hardware prefers).
file(GLOB_RECURSE shader_includes CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/shaders/*.glsl ${PROJECT_SOURCE_DIR}/shaders/*.h)
set(spirv_dir ${PROJECT_BINARY_DIR}/spirv)
file(MAKE_DIRECTORY ${spirv_dir}/spirv)

# Adds the headers of these kernels to the list `headers`.
function(capcon_kernels headers)
  foreach(source ${ARGN})
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
      list(APPEND ${headers} ${header})
    endforeach()
  endforeach()
  set(${headers} ${${headers}} PARENT_SCOPE)
endfunction()

file(GLOB kernel_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/shaders/*.comp)
capcon_kernels(spirv_headers ${kernel_sources})
add_custom_target(capcon_spirv DEPENDS ${spirv_headers})
add_library(capcon_shaders INTERFACE)
target_include_directories(capcon_shaders INTERFACE ${spirv_dir})
add_dependencies(capcon_shaders capcon_spirv)
