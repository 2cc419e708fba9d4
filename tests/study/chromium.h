#pragma once

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "base/file.h"

namespace capcon {

/// Chromium without a window, where it is installed.
inline bool has_chromium() {
  static const bool there = std::system("command -v chromium >/dev/null 2>&1") == 0;
  return there;
}

/// Opens a page with `options` (--dump-dom, --screenshot=FILE ...), in `folder`, and hands back what it
/// prints.
inline std::string chromium(const std::filesystem::path& folder, const std::filesystem::path& page,
                            const std::string& options) {
  const auto out = folder / "chromium.txt";
  const std::string command = fmt::format(
      "timeout 180 chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run "
      "--disable-background-networking --disable-component-update --disable-sync --hide-scrollbars "
      "--user-data-dir='{}' --virtual-time-budget=8000 {} 'file://{}' >'{}' 2>/dev/null",
      (folder / "profile").string(), options, std::filesystem::absolute(page).string(), out.string());
  if (std::system(command.c_str()) != 0) return {};
  return read_file(out);
}

}  // namespace capcon
