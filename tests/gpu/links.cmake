# Kernels of the tests, tests/shaders/*.comp.
set(links capcon_shaders)
file(GLOB test_kernels CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/shaders/*.comp)
capcon_kernels(sources ${test_kernels})
