# cmake -DNAME=report_css -DFILE=report.css -DOUT=report_css.cpp -P embed_file.cmake: a file's bytes as
# capcon::embedded::report_css(). An empty FILE gives none.
set(bytes)
if(FILE)
  file(READ ${FILE} hex HEX)
  string(REGEX REPLACE "(................................................)" "\\1\n" hex "${hex}")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
endif()
file(WRITE ${OUT} "// Made by cmake/embed_file.cmake.
#include <string_view>
namespace capcon::embedded {
std::string_view ${NAME}() {
  static constexpr unsigned char kBytes[] = {${bytes}0};
  return {reinterpret_cast<const char*>(kBytes), sizeof(kBytes) - 1};
}
}  // namespace capcon::embedded
")
