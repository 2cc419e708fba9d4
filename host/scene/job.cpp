#include "scene/job.h"

#include <nlohmann/json.hpp>

namespace capcon {

nlohmann::json to_json(const Timings& timings) {
  return {{"wall", timings.wall}, {"device", timings.device}};
}

}  // namespace capcon
