# Installs into a folder of the build tree, moves that, runs the program from there, and builds examples/ against it by find_package and
# by pkg-config. Variables: BUILD, SOURCE, CXX, FLAGS (of the sanitizers).
cmake_minimum_required(VERSION 3.25)
set(root ${BUILD}/install_test)
file(REMOVE_RECURSE ${root})

function(run out)  # the rest is a command, which must succeed
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE text ERROR_VARIABLE errors)
  if(NOT code EQUAL 0)
    message(FATAL_ERROR "${ARGN}\nended with ${code}\n${text}${errors}")
  endif()
  set(${out} "${text}" PARENT_SCOPE)
endfunction()

function(expect text pattern)
  if(NOT text MATCHES "${pattern}")
    message(FATAL_ERROR "\"${pattern}\" is not in\n${text}")
  endif()
endfunction()

run(ignored ${CMAKE_COMMAND} --install ${BUILD} --prefix ${root}/before)
file(RENAME ${root}/before ${root}/moved)
set(prefix ${root}/moved)
file(GLOB_RECURSE files RELATIVE ${prefix} ${prefix}/*)
foreach(file bin/capcon share/man/man1/capcon.1 share/bash-completion/completions/capcon share/zsh/vendor-completions/_capcon
             share/fish/vendor_completions.d/capcon.fish share/capcon/tiles/c2n16.tiles share/capcon/ensembles/disk.ensembles
             share/capcon/scenes/courtyard.pbrt share/capcon/scenes/geometry/courtyard-shapes.pbrt)
  if(NOT file IN_LIST files)
    message(FATAL_ERROR "${file} is not installed: ${files}")
  endif()
endforeach()

# The program finds the installed data, not those of the source tree: the broken file that it complains of is the installed one.
set(capcon ${prefix}/bin/capcon)
run(tiling ${capcon} tiles show c2n16 --width 2)
expect("${tiling}" "<svg")
run(checked ${capcon} check ${prefix}/share/capcon/scenes/courtyard.pbrt)
expect("${checked}" "950,466")
file(RENAME ${prefix}/share/capcon/tiles/c2n16.tiles ${root}/kept)
file(WRITE ${prefix}/share/capcon/tiles/c2n16.tiles "no tiles\n")
execute_process(COMMAND ${capcon} tiles show c2n16 --width 2 ERROR_VARIABLE errors OUTPUT_QUIET)
expect("${errors}" "moved/bin/\\.\\./share/capcon/tiles|moved/share/capcon/tiles")
file(RENAME ${root}/kept ${prefix}/share/capcon/tiles/c2n16.tiles)

# The library, as CMake finds it.
run(ignored ${CMAKE_COMMAND} -S ${SOURCE}/examples -B ${root}/examples -DCMAKE_PREFIX_PATH=${prefix} -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_CXX_FLAGS=${FLAGS})
run(ignored ${CMAKE_COMMAND} --build ${root}/examples)
run(said ${root}/examples/occlusion)
expect("${said}" "capcon-domain +64 samples: error 0\\.0[01]")
expect("${said}" "16 tiles of 16 points, a tiling of 4 x 4: 256 points")

# And as pkg-config does.
find_program(pkg_config pkg-config)
if(pkg_config)
  file(GLOB folder ${prefix}/lib*/pkgconfig ${prefix}/lib/*/pkgconfig)
  run(flags ${CMAKE_COMMAND} -E env PKG_CONFIG_PATH=${folder} ${pkg_config} --cflags --libs capcon)
  string(STRIP "${flags}" flags)
  string(REPLACE " " ";" flags "${flags}")  # as an unquoted $(pkg-config ...) has it
  separate_arguments(own UNIX_COMMAND "${FLAGS}")
  run(ignored ${CXX} ${own} -std=c++17 ${SOURCE}/examples/occlusion.cpp -o ${root}/occlusion ${flags})
  file(RENAME ${prefix} ${root}/before)  # where its data were when it was installed
  run(again ${root}/occlusion)
  if(NOT again STREQUAL said)
    message(FATAL_ERROR "${again}\nis not\n${said}")
  endif()
endif()
file(REMOVE_RECURSE ${root})
