# A kernel of the tests.
set(links capcon_shaders)
capcon_kernels(sources ${PROJECT_SOURCE_DIR}/tests/shaders/loops.comp)
