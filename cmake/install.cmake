# What `cmake --install` and `cpack` ship (docs/install.md): the program with its data, manual and completions, and the library
# capcon::sampling with its headers. Nothing here changes how the rest is compiled.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# The public interface (include/capcon) and all that it needs in one archive, so that who links it needs fmt and threads alone.
file(GLOB api_sources CONFIGURE_DEPENDS host/api/*.cpp)
add_library(capcon_api STATIC ${api_sources})
target_include_directories(capcon_api PUBLIC include)
target_link_libraries(capcon_api PRIVATE capcon_sampling)
set(archive ${PROJECT_BINARY_DIR}/libcapcon-sampling.a)
set(parts capcon_api capcon_sampling capcon_tiling capcon_points capcon_base)
set(script "create ${archive}\n")
foreach(part ${parts})
  string(APPEND script "addlib $<TARGET_FILE:${part}>\n")
endforeach()
file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/sampling_archive.mri CONTENT "${script}save\nend\n")
add_custom_command(OUTPUT ${archive} COMMAND ${CMAKE_AR} -M < ${PROJECT_BINARY_DIR}/sampling_archive.mri
  DEPENDS ${parts} COMMENT "One archive of capcon::sampling" VERBATIM)
add_custom_target(capcon_sampling_archive ALL DEPENDS ${archive})

set(data ${CMAKE_INSTALL_DATADIR}/capcon)
install(TARGETS capcon RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
install(DIRECTORY tiles ensembles DESTINATION ${data} COMPONENT program PATTERN "*.md" EXCLUDE)
install(DIRECTORY scenes/ DESTINATION ${data}/scenes COMPONENT program PATTERN generator EXCLUDE)
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program RENAME copyright)
install(FILES README.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT program)
# The program writes its own manual page and completions: from the tables that it reads its options with.
install(CODE "
  function(capcon_says file)
    execute_process(COMMAND \"$<TARGET_FILE:capcon>\" \${ARGN} OUTPUT_FILE \"${PROJECT_BINARY_DIR}/\${file}\" COMMAND_ERROR_IS_FATAL ANY)
  endfunction()
  capcon_says(capcon.1 man)
  capcon_says(capcon.bash completion bash)
  capcon_says(_capcon completion zsh)
  capcon_says(capcon.fish completion fish)" COMPONENT program)
install(FILES ${PROJECT_BINARY_DIR}/capcon.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
install(FILES ${PROJECT_BINARY_DIR}/capcon.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME capcon
  COMPONENT program)
install(FILES ${PROJECT_BINARY_DIR}/_capcon DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT program)
install(FILES ${PROJECT_BINARY_DIR}/capcon.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT program)

install(FILES ${archive} DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library)
install(DIRECTORY include/capcon DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT library)
# For those who do not come by CMake, where the data lie is written down when it is known.
install(CODE "
  get_filename_component(prefix \"\${CMAKE_INSTALL_PREFIX}\" ABSOLUTE)
  file(WRITE \"${PROJECT_BINARY_DIR}/data_dir.h\" \"#pragma once\n#define CAPCON_DATA_DIR \\\"\${prefix}/${data}\\\"\n\")" COMPONENT library)
install(FILES ${PROJECT_BINARY_DIR}/data_dir.h DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/capcon COMPONENT library)
set(cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/capcon)
configure_package_config_file(cmake/capconConfig.cmake.in ${PROJECT_BINARY_DIR}/capconConfig.cmake
  INSTALL_DESTINATION ${cmake_dir} PATH_VARS CMAKE_INSTALL_INCLUDEDIR CMAKE_INSTALL_LIBDIR CMAKE_INSTALL_DATADIR)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/capconConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/capconConfig.cmake ${PROJECT_BINARY_DIR}/capconConfigVersion.cmake DESTINATION ${cmake_dir}
  COMPONENT library)
file(RELATIVE_PATH CAPCON_PC_UP /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" CAPCON_PC_UP "${CAPCON_PC_UP}")
configure_file(cmake/capcon.pc.in ${PROJECT_BINARY_DIR}/capcon.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/capcon.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT library)

include(cmake/package.cmake)
