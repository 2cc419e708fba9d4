#include "scene/obj_reader.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "scene/number_text.h"
#include "scene/text_lines.h"

namespace capcon {
namespace {

/// Indices of a corner into positions, uvs and normals; kNone for those it lacks.
using Corner = std::array<std::uint32_t, 3>;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr const char* kStatement[] = {"v", "vt", "vn"};

struct CornerHash {
  std::size_t operator()(const Corner& corner) const {
    std::uint64_t hash = 0;
    for (const std::uint32_t index : corner)
      hash = (hash ^ index) * 0x9E3779B97F4A7C15ull, hash ^= hash >> 32;
    return hash;
  }
};

class ObjReader {
 public:
  ObjReader(std::string_view bytes, const std::string& name, const ReadOptions& options)
      : lines_(bytes), name_(name), options_(options) {}

  TriangleMesh read() {
    while (lines_.next()) statement(split_words(lines_.line()));
    return options_.normals || options_.uvs ? split() : plain();
  }

 private:
  SourcePlace place() const { return {name_, lines_.number(), 0}; }

  void statement(const std::vector<std::string_view>& words) {
    if (words.empty()) return;
    if (words[0] == "v") {
      read_floats(words, 3, positions_);
    } else if (words[0] == "vt") {
      read_floats(words, 2, uvs_);
    } else if (words[0] == "vn") {
      read_floats(words, 3, normals_);
    } else if (words[0] == "f") {
      read_face(words);
    }
  }

  template <typename Vector>
  void read_floats(const std::vector<std::string_view>& words, int count, std::vector<Vector>& into) {
    Vector vector(0);
    // A texture coordinate may have one number alone.
    const int least = count == 2 ? 1 : count;
    for (int i = 0; i < count; ++i) {
      if (std::size_t(i) + 1 >= words.size()) {
        if (i >= least) break;
        throw InputError(place(), fmt::format("\"{}\" needs {} numbers", words[0], count));
      }
      double value = 0;
      const std::string_view word = words[i + 1];
      if (parse_number(word, value) == NumberText::malformed) {
        throw InputError(place(), fmt::format("\"{}\" is not a number", word.substr(0, 40)));
      }
      vector[i] = static_cast<float>(value);
      if (!std::isfinite(vector[i]))
        throw InputError(place(), fmt::format("\"{}\" is not a finite number", word.substr(0, 40)));
    }
    into.push_back(vector);
  }

  void read_face(const std::vector<std::string_view>& words) {
    if (words.size() < 4) throw InputError(place(), "a face needs 3 corners or more");
    const Corner first = read_corner(words[1]);
    Corner previous = read_corner(words[2]);
    for (std::size_t i = 3; i < words.size(); ++i) {
      const Corner next = read_corner(words[i]);
      corners_.insert(corners_.end(), {first, previous, next});
      previous = next;
    }
  }

  /// "v", "v/vt", "v//vn" or "v/vt/vn", each from 1 or counted backwards from -1.
  Corner read_corner(std::string_view word) {
    const std::size_t counts[] = {positions_.size(), uvs_.size(), normals_.size()};
    Corner corner{kNone, kNone, kNone};
    const char* at = word.data();
    const char* end = at + word.size();
    for (int i = 0; i < 3 && at <= end; ++i) {
      if (i > 0 && (at == end || *at == '/')) {  // left out
        ++at;
        continue;
      }
      long long index = 0;
      const auto [stop, error] = std::from_chars(at, end, index);
      if (error != std::errc{} || (stop != end && *stop != '/')) break;
      const long long resolved = index < 0 ? static_cast<long long>(counts[i]) + index : index - 1;
      if (resolved < 0 || resolved >= static_cast<long long>(counts[i])) {
        throw InputError(place(), fmt::format("this face names {} number {}, but {} are defined so far",
                                              kStatement[i], index, counts[i]));
      }
      corner[i] = static_cast<std::uint32_t>(resolved);
      at = stop + 1;
    }
    if (at <= end || corner[0] == kNone) {
      throw InputError(place(), fmt::format("\"{}\" is not a corner; write v, v/vt, v//vn or v/vt/vn",
                                            word.substr(0, 40)));
    }
    return corner;
  }

  TriangleMesh plain() {
    TriangleMesh mesh;
    mesh.positions = std::move(positions_);
    mesh.triangles.reserve(corners_.size() / 3);
    for (std::size_t i = 0; i < corners_.size(); i += 3) {
      mesh.triangles.emplace_back(corners_[i][0], corners_[i + 1][0], corners_[i + 2][0]);
    }
    return mesh;
  }

  /// One vertex for each distinct corner, in the order of first use.
  TriangleMesh split() {
    bool all_uvs = options_.uvs, all_normals = options_.normals;
    for (const Corner& corner : corners_) {
      all_uvs = all_uvs && corner[1] != kNone;
      all_normals = all_normals && corner[2] != kNone;
    }
    TriangleMesh mesh;
    std::unordered_map<Corner, std::uint32_t, CornerHash> vertices;
    std::vector<std::uint32_t> indices;
    for (Corner corner : corners_) {
      if (!all_uvs) corner[1] = kNone;
      if (!all_normals) corner[2] = kNone;
      const auto [found, is_new] =
          vertices.emplace(corner, static_cast<std::uint32_t>(mesh.positions.size()));
      indices.push_back(found->second);
      if (!is_new) continue;
      mesh.positions.push_back(positions_[corner[0]]);
      if (all_uvs) mesh.uvs.push_back(uvs_[corner[1]]);
      if (all_normals) mesh.normals.push_back(normals_[corner[2]]);
    }
    for (std::size_t i = 0; i < indices.size(); i += 3) {
      mesh.triangles.emplace_back(indices[i], indices[i + 1], indices[i + 2]);
    }
    return mesh;
  }

  TextLines lines_;
  const std::string& name_;
  const ReadOptions& options_;
  std::vector<glm::vec3> positions_;
  std::vector<glm::vec2> uvs_;
  std::vector<glm::vec3> normals_;
  std::vector<Corner> corners_;  ///< three a triangle
};

}  // namespace

TriangleMesh parse_obj(std::string_view bytes, const std::string& name, const ReadOptions& options) {
  return ObjReader(bytes, name, options).read();
}

}  // namespace capcon
