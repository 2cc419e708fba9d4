set(links capcon_reference)
# A kernel of the tests.
capcon_kernels(sources ${PROJECT_SOURCE_DIR}/tests/shaders/shading_samples.comp)
