#pragma once

#include <string>
#include <string_view>

#include "study/close_ups.h"

namespace capcon {

/// A close-ups.json: all of close-ups but their images.
struct CloseUpFacts {
  std::string hash;  ///< of the settings they were made with
  CloseUps close_ups;
};

/// An exception where it is none, or says what no study says.
CloseUpFacts parse_close_up_facts(std::string_view text);

}  // namespace capcon
