#pragma once

#include <string>

namespace capcon {

/// Looks through the headers of an EXR file before OpenEXR allocates what they claim: attributes as long as
/// the file at most, sizes that this program reads (2^28 pixels), and a file that is long enough for its
/// chunks and, by what its compression can do, for its pixels. std::runtime_error with a phrase otherwise.
void check_exr(const std::string& name, const std::string& bytes);

}  // namespace capcon
