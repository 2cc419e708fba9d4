#include <unistd.h>

#include <fmt/format.h>

#include "base/file.h"
#include "study/shard.h"
#include "study/study_work.h"

namespace capcon {
namespace fs = std::filesystem;

namespace {

/// Puts it where all shards look for it, unless another was quicker: then hands back that one. A link is made
/// or not made as one step, on network file systems too.
ReferenceImage publish(const fs::path& path, const ReferenceImage& reference, const StudySettings& settings,
                       const std::string& key) {
  const fs::path mine = path.parent_path() / fmt::format("reference.{}-{}.exr", ::getpid(), key);
  write_reference(mine, reference, settings, key);
  std::error_code error, ignored;
  fs::create_hard_link(mine, path, error);
  if (error) {
    if (auto theirs = read_reference(path, key)) {
      fs::remove(mine, ignored);
      return std::move(*theirs);
    }
    // Another study's, or a file system without links.
    fs::rename(mine, path, error);
    if (error) fail_to_write(path);
  }
  fs::remove(mine, ignored);
  return reference;
}

template <class T>
std::span<std::byte> bytes_of(std::vector<T>& values) {
  return std::as_writable_bytes(std::span(values));
}

/// Rank 0's to everybody.
void spread(ReferenceImage& reference, const StudySettings& settings, const Ranks& ranks) {
  struct Shape {
    int channels;
    double error, coarse_error;
  };
  const Shape shape =
      ranks.broadcast_value(Shape{reference.image.channels, reference.error, reference.coarse_error});
  if (!ranks.first()) {
    reference = {Image(settings.width, settings.height, shape.channels), shape.error, shape.coarse_error};
  }
  ranks.broadcast(bytes_of(reference.image.pixels));
}

/// All groups at rank 0, each rendered by the rank of its number.
std::vector<Image> render_groups(const StudySettings& settings, StudyWork& work, const Ranks& ranks) {
  std::vector<Image> groups;
  for (std::uint32_t g = 0; g < settings.reference_groups; ++g) {
    const int by = static_cast<int>(g) % ranks.size();
    if (by == ranks.rank()) {
      groups.push_back(work.reference_group(g));
    } else {
      groups.emplace_back();
    }
  }
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const int by = static_cast<int>(g) % ranks.size();
    if (by == 0) continue;
    if (by == ranks.rank()) ranks.send(0, bytes_of(groups[g].pixels));
    if (!ranks.first()) continue;
    groups[g] = Image(settings.width, settings.height, groups[0].channels);
    ranks.receive(by, bytes_of(groups[g].pixels));
  }
  return groups;
}

}  // namespace

ReferenceImage shared_reference(const StudySettings& settings, const StudyDevice& device,
                                const RunnerOptions& options, const Ranks& ranks) {
  const fs::path path = shards_folder(options.directory) / "reference.exr";
  const std::string key = study_key(settings);
  ReferenceImage reference;
  bool there = false;
  if (ranks.first()) {
    create_folder(path.parent_path());
    check_writable(path);
    if (auto before = read_reference(path, key)) {
      reference = std::move(*before);
      there = true;
    }
  }
  if (!ranks.broadcast_value(there)) {
    StudyWork work(settings, device, options, nullptr, {});
    const std::vector<Image> groups = render_groups(settings, work, ranks);
    if (ranks.first()) reference = publish(path, combine_groups(groups), settings, key);
  }
  spread(reference, settings, ranks);
  return reference;
}

}  // namespace capcon
