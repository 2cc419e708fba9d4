#include "render/device_context.h"

#include <fmt/format.h>

#include <chrono>

#include "base/error.h"

namespace capcon {
namespace {

/// `options` if its words are known.
const RendererOptions& checked(const RendererOptions& options) {
  const auto one_of = [](const std::string& word, std::initializer_list<const char*> known,
                         const char* option) {
    std::string list;
    for (const char* k : known) {
      if (word == k) return;
      list += std::string(list.empty() ? "" : ", ") + k;
    }
    throw InputError(fmt::format("{} {}: choose one of {}", option, word, list));
  };
  one_of(options.fetch, {"auto", "texel", "storage"}, "--fetch");
  one_of(options.instancing, {"auto", "flat", "two-level"}, "--instancing");
  one_of(options.tree, {"auto", "fast", "best"}, "--tree");
  return options;
}

}  // namespace

DeviceContext::DeviceContext(const RendererOptions& options)
    : instance(checked(options).validate),
      description(instance.choose(options.device)),
      device(instance, description),
      kernels(device, options.fetch == "texel" || (options.fetch == "auto" && device.is_cpu())) {}

PendingDevice open_device(const RendererOptions& options) {
  return std::async(std::launch::async, [options] {
    const auto start = std::chrono::steady_clock::now();
    auto context = std::make_unique<DeviceContext>(options);
    context->open_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return context;
  });
}

}  // namespace capcon
