#include "sampling/point_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>

#include "base/error.h"
#include "base/file.h"
#include "base/hash.h"
#include "points/import_points.h"

namespace capcon {
namespace fs = std::filesystem;

namespace {

constexpr std::string_view kPrefix = "file:";
constexpr std::string_view kNumber = "{n}";
constexpr std::size_t kLongestLabel = 40;
constexpr std::uint32_t kAnyCount = 64;  // of samplers for some numbers of points only

/// The files that a path with "{n}" stands for, by name; the path itself where it has none.
std::vector<fs::path> files_of(const std::string& path) {
  const std::size_t at = path.find(kNumber);
  if (at == std::string::npos) return {path};
  const fs::path pattern(path);
  const std::string name = pattern.filename().string();
  const std::size_t begin = name.find(kNumber);
  if (begin == std::string::npos)
    throw InputError(fmt::format("{}: {{n}} must stand in the file's own name, not in a folder's", path));
  const std::string_view before = std::string_view(name).substr(0, begin),
                         behind = std::string_view(name).substr(begin + kNumber.size());
  std::vector<fs::path> found;
  std::error_code error;
  const fs::path folder = pattern.has_parent_path() ? pattern.parent_path() : fs::path(".");
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    const std::string file = entry.path().filename().string();
    if (file.size() <= before.size() + behind.size() || !file.starts_with(before) || !file.ends_with(behind))
      continue;
    const std::string number = file.substr(before.size(), file.size() - before.size() - behind.size());
    if (std::all_of(number.begin(), number.end(), [](char c) { return c >= '0' && c <= '9'; }))
      found.push_back(entry.path());
  }
  if (found.empty()) throw InputError(path + ": there is no file of this name with a number for {n}");
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace

bool is_point_file(std::string_view sampler) {
  return sampler.starts_with(kPrefix);
}

PointFile parse_point_file(std::string_view sampler) {
  PointFile file;
  std::string_view rest = sampler.substr(kPrefix.size());
  bool randomised = false;
  for (;;) {
    const std::size_t colon = rest.rfind(':');
    const std::string_view word = colon == rest.npos ? std::string_view() : rest.substr(colon + 1);
    const bool how = word == "shift" || word == "xor" || word == "none";
    if (!how && word != "sequence") break;
    if (how && randomised)
      throw InputError(fmt::format("{}: points are randomised in one way: shift, xor or none", sampler));
    if (how) {
      using enum PointFile::Randomisation;
      file.randomisation = word == "shift" ? shift : word == "xor" ? xor_digits : none;
      randomised = true;
    } else {
      file.sequence = true;
    }
    rest = rest.substr(0, colon);
  }
  if (rest.empty())
    throw InputError(fmt::format("{}: which file? Write file:PATH, or file:PATH:xor", sampler));
  file.path = rest;
  return file;
}

std::string sampler_label(std::string_view sampler) {
  if (!is_point_file(sampler)) return std::string(sampler);
  const PointFile file = parse_point_file(sampler);
  std::string label = fs::path(file.path).stem().string();
  if (const std::size_t at = label.find(kNumber); at != std::string::npos)
    label.replace(at, kNumber.size(), "n");
  for (char& c : label) {
    const bool safe = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                      c == '.' || c == '_' || c == '-';
    if (!safe) c = '_';
  }
  if (label.size() > kLongestLabel) label.resize(kLongestLabel);
  using enum PointFile::Randomisation;
  if (file.randomisation == xor_digits) label += "-xor";
  if (file.randomisation == none) label += "-none";
  // What studies take for a variant, or for another sampler.
  const auto& names = sampler_names();
  const bool taken =
      std::find(names.begin(), names.end(), label) != names.end() || label.starts_with("capcon-");
  return taken || label.ends_with("-naive") || label.ends_with("-naive2") ? label + "-file" : label;
}

std::vector<std::string> sampler_labels(const std::vector<std::string>& samplers) {
  std::vector<std::string> labels;
  std::set<std::string> used;
  std::copy_if(samplers.begin(), samplers.end(), std::inserter(used, used.end()),
               [](const std::string& sampler) { return !is_point_file(sampler); });
  for (const std::string& sampler : samplers) {
    const std::string label = sampler_label(sampler);
    std::string other = label;
    for (int i = 2; is_point_file(sampler) && used.contains(other); ++i)
      other = fmt::format("{}-{}", label, i);
    labels.push_back(other);
    used.insert(other);
  }
  return labels;
}

void check_sampler(std::string_view sampler) {
  if (!is_point_file(sampler)) {
    const auto& names = sampler_names();
    if (std::find(names.begin(), names.end(), sampler) == names.end())
      make_sampler(sampler, kAnyCount, 1);  // says which there are
    return;
  }
  for (const fs::path& file : files_of(parse_point_file(sampler).path)) import_points(file);
}

std::uint64_t point_file_fingerprint(std::string_view sampler) {
  if (!is_point_file(sampler)) return 0;
  std::string all;
  for (const fs::path& file : files_of(parse_point_file(sampler).path))
    all += fmt::format("{} {:016x}\n", file.filename().string(), fnv1a64(read_file(file)));
  return fnv1a64(all);
}

}  // namespace capcon
