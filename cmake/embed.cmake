# Files that pages carry in themselves: compiled into the library that writes them.
function(capcon_embed library name file)
  set(out ${PROJECT_BINARY_DIR}/embedded/${name}.cpp)
  add_custom_command(OUTPUT ${out}
    COMMAND ${CMAKE_COMMAND} -DNAME=${name} -DFILE=${file} -DOUT=${out} -P ${PROJECT_SOURCE_DIR}/cmake/embed_file.cmake
    DEPENDS ${file} ${PROJECT_SOURCE_DIR}/cmake/embed_file.cmake COMMENT "Embedding ${name}" VERBATIM)
  target_sources(capcon_${library} PRIVATE ${out})
endfunction()

# The chart library of the reports, pinned: what the tests have seen. Without it charts are the drawings that need no scripts.
set(DYGRAPHS_VERSION 2.2.1)
set(DYGRAPHS_SHA256 065bb9a7158dadc02b1c204b962dcc45279304dffbe80d5cb898ff33afac5c40)
find_file(CAPCON_DYGRAPHS dygraph.min.js PATHS /usr/share/javascript/dygraphs DOC "dygraph.min.js of dygraphs ${DYGRAPHS_VERSION}")
set(dygraphs "")
if(NOT CAPCON_DYGRAPHS OR NOT EXISTS "${CAPCON_DYGRAPHS}")
  message(STATUS "dygraphs not found (Debian: libjs-dygraphs): charts of reports will not zoom, and are drawings")
else()
  file(SHA256 ${CAPCON_DYGRAPHS} found)
  if(found STREQUAL DYGRAPHS_SHA256)
    set(dygraphs ${CAPCON_DYGRAPHS})
  else()
    message(WARNING "${CAPCON_DYGRAPHS} is not that of dygraphs ${DYGRAPHS_VERSION} (SHA-256 ${found}, not ${DYGRAPHS_SHA256}): "
      "charts of reports will be drawings. Name the right file with -DCAPCON_DYGRAPHS=FILE.")
  endif()
endif()
