# Kernels of the tests, tests/shaders/*.comp, in both ways of fetching.
set(links capcon_shaders)
file(GLOB test_kernels CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/shaders/*.comp)
foreach(source ${test_kernels})
  get_filename_component(kernel ${source} NAME_WE)
  foreach(fetch texel storage)
    string(TOUPPER ${fetch} fetch_upper)
    set(header ${spirv_dir}/spirv/${kernel}_${fetch}.h)
    add_custom_command(
      OUTPUT ${header}
      COMMAND ${GLSLANG_VALIDATOR} -V --target-env vulkan1.2 --quiet -DFETCH_${fetch_upper}
              -I${PROJECT_SOURCE_DIR}/shaders --vn k_${kernel}_${fetch}_spirv -o ${header} ${source}
      DEPENDS ${source} ${shader_includes}
      COMMENT "SPIR-V ${kernel} (${fetch}, test)"
      VERBATIM)
    list(APPEND sources ${header})
  endforeach()
endforeach()
