# A kernel of the tests.
set(links capcon_shaders capcon_image capcon_fault_layer_place)
capcon_kernels(sources ${PROJECT_SOURCE_DIR}/tests/shaders/loops.comp)

# A Vulkan layer that fails on demand, with its manifest beside it, where the loader is told to look.
file(GLOB layer_sources CONFIGURE_DEPENDS gpu/fault_layer/*.cpp)
add_library(capcon_fault_layer MODULE ${layer_sources})
target_link_libraries(capcon_fault_layer PRIVATE Vulkan::Headers)
target_compile_options(capcon_fault_layer PRIVATE -O1 -fvisibility=hidden)
set(layer_folder ${CMAKE_CURRENT_BINARY_DIR}/layers)
set_target_properties(capcon_fault_layer PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${layer_folder})
configure_file(gpu/fault_layer/manifest.json.in ${layer_folder}/VkLayer_capcon_faults.json COPYONLY)
add_library(capcon_fault_layer_place INTERFACE)
add_dependencies(capcon_fault_layer_place capcon_fault_layer)
target_compile_definitions(capcon_fault_layer_place INTERFACE CAPCON_LAYERS="${layer_folder}")
