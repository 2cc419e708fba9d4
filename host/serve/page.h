#pragma once

#include <string_view>

namespace capcon::serve {

// The files of page/, embedded at build time.
extern const std::string_view kPageHtml, kPageCss, kPageJs;

}  // namespace capcon::serve
