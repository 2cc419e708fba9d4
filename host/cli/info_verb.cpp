#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file.h"
#include "base/parallel.h"
#include "cli/verbs.h"
#include "gpu/instance.h"

namespace capcon::cli {
namespace {

/// All devices; none where there is no driver, with the reason on stderr.
std::vector<gpu::DeviceDescription> find_devices() {
  try {
    return gpu::Instance(false).devices();
  } catch (const Failure& none) {
    fmt::print(stderr, "capcon: {}\n", none.what());
    return {};
  }
}

void run(bool json) {
  const auto devices = find_devices();
  if (json) {
    nlohmann::json list = nlohmann::json::array();
    for (const auto& d : devices) {
      list.push_back({{"name", d.name},
                      {"driver", d.driver},
                      {"vulkan", d.api_version},
                      {"kind", d.kind},
                      {"usable", d.usable()},
                      {"subgroup_size", d.subgroup_size},
                      {"memory_bytes", d.memory_bytes},
                      {"max_storage_buffer_bytes", d.max_storage_bytes},
                      {"max_texel_buffer_texels", d.max_texels}});
    }
    fmt::print(
        "{}\n",
        nlohmann::json{{"version", version()}, {"threads", thread_count()}, {"devices", list}}.dump(2));
    return;
  }
  fmt::print("capcon {}, {} threads\n", version(), thread_count());
  if (devices.empty()) fmt::print("no Vulkan device; --device reference works without one\n");
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const auto& d = devices[i];
    fmt::print("{}: {} ({}{})\n", i, d.name, d.kind, d.usable() ? "" : ", not usable: it has no " + d.lacks);
    fmt::print("   driver {}, Vulkan {}, subgroups of {}\n", d.driver, d.api_version, d.subgroup_size);
    fmt::print("   memory {:.1f} GiB, storage buffers up to {:.0f} MiB, texel buffers up to {:.0f} MiB\n",
               static_cast<double>(d.memory_bytes) / (1 << 30),
               static_cast<double>(d.max_storage_bytes) / (1 << 20),
               static_cast<double>(d.max_texels) * 16 / (1 << 20));
  }
  fmt::print("reference: double precision on the CPU, no Vulkan needed\n");
}

}  // namespace

void add_info_verb(CLI::App& app) {
  CLI::App* verb = app.add_subcommand("info", "List Vulkan devices and their limits");
  auto json = std::make_shared<bool>(false);
  verb->add_flag("--json", *json, "JSON on stdout");
  verb->callback([json] { run(*json); });
}

}  // namespace capcon::cli
