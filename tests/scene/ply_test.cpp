#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "scene/ply_reader.h"
#include "scene_text.h"

namespace capcon {
namespace {

using test::error_of;

/// Writes PLY values in any of the three formats.
class Writer {
 public:
  explicit Writer(const std::string& format) : format_(format) {
    bytes_ = "ply\nformat " + format + " 1.0\n";
  }
  Writer& header(const std::string& lines) {
    bytes_ += lines + "end_header\n";
    return *this;
  }
  template <typename T>
  Writer& put(T value) {
    if (format_ == "ascii") {
      bytes_ += std::to_string(value) + ' ';
      return *this;
    }
    char raw[sizeof(T)];
    std::memcpy(raw, &value, sizeof(T));
    if (format_ == "binary_big_endian") std::reverse(raw, raw + sizeof(T));
    bytes_.append(raw, sizeof(T));
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string format_;
  std::string bytes_;
};

class PlyFormats : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(All, PlyFormats,
                         testing::Values("ascii", "binary_little_endian", "binary_big_endian"));

TEST_P(PlyFormats, TypesOrdersPolygonsAndExtras) {
  Writer w(GetParam());
  w.header(
      "comment made by a test\nobj_info nothing\nelement camera 1\nproperty double a\nproperty list uchar "
      "short b\n"
      "element face 3\nproperty uchar flags\nproperty list ushort uint vertex_index\nproperty list uchar "
      "float texcoord\n"
      "element vertex 5\nproperty short z\nproperty float t\nproperty double x\nproperty uchar red\nproperty "
      "float y\n"
      "property float s\nproperty char nx\nproperty float ny\nproperty float nz\nelement edge 1\nproperty "
      "int v1\n");
  w.put(1.5).put<std::uint8_t>(2).put<std::int16_t>(-3).put<std::int16_t>(4);
  const std::vector<std::vector<std::uint32_t>> faces = {{0, 1, 2}, {0, 1, 2, 3}, {4, 3, 2, 1, 0}};
  for (const auto& face : faces) {
    w.put<std::uint8_t>(9).put(static_cast<std::uint16_t>(face.size()));
    for (const std::uint32_t index : face) w.put(index);
    w.put<std::uint8_t>(1).put(0.5f);
  }
  for (int i = 0; i < 5; ++i) {
    w.put(static_cast<std::int16_t>(-i))
        .put(i * 0.25f)
        .put(i * 0.5)
        .put<std::uint8_t>(200)
        .put(i + 0.5f)
        .put(i * 0.125f);
    w.put(static_cast<std::int8_t>(i == 0 ? -1 : 1)).put(2.0f).put(3.0f);
  }
  w.put<std::int32_t>(7);

  const TriangleMesh mesh = parse_ply(w.bytes(), "m.ply", {true, true});
  ASSERT_EQ(mesh.positions.size(), 5u);
  EXPECT_EQ(mesh.positions[3], glm::vec3(1.5f, 3.5f, -3));
  ASSERT_EQ(mesh.normals.size(), 5u);
  EXPECT_EQ(mesh.normals[0], glm::vec3(-1, 2, 3));
  ASSERT_EQ(mesh.uvs.size(), 5u);
  EXPECT_EQ(mesh.uvs[4], glm::vec2(0.5f, 1));
  const std::vector<glm::uvec3> expected = {{0, 1, 2}, {0, 1, 2}, {0, 2, 3}, {4, 3, 2}, {4, 2, 1}, {4, 1, 0}};
  EXPECT_EQ(mesh.triangles, expected);

  const TriangleMesh bare = parse_ply(w.bytes(), "m.ply");
  EXPECT_EQ(bare.positions, mesh.positions);
  EXPECT_TRUE(bare.normals.empty() && bare.uvs.empty()) << "not asked for";

  // Every shorter file is an error, but for the blank at the end of the ascii one.
  const std::size_t whole = w.bytes().size() - (std::string(GetParam()) == "ascii");
  for (std::size_t size = 0; size < whole; ++size) {
    const std::string message =
        error_of([&] { parse_ply(std::string_view(w.bytes()).substr(0, size), "m.ply"); });
    EXPECT_EQ(message.rfind("m.ply:", 0), 0u) << size << " of " << whole << ": " << message;
  }
}

const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
const std::string kFace = "property list uchar int vertex_indices\n";

std::string ascii(const std::string& vertices, const std::string& faces, const std::string& data) {
  return "ply\nformat ascii 1.0\nelement vertex " + vertices + "\n" + kXyz + "element face " + faces + "\n" +
         kFace + "end_header\n" + data;
}

TEST(Ply, LineEndsMayBeOfAnyKind) {
  std::string text = ascii("3", "1", "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  std::string windows;
  for (const char c : text) windows += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(parse_ply(windows, "m.ply").triangles.size(), 1u);
  std::replace(text.begin(), text.end(), '\n', '\r');
  EXPECT_EQ(parse_ply(text, "m.ply").triangles.size(), 1u);
}

struct Case {
  const char* name;
  std::string bytes;
  std::string message;
};

class PlyError : public testing::TestWithParam<Case> {};

TEST_P(PlyError, SaysWhereAndWhat) {
  EXPECT_EQ(error_of([] { parse_ply(GetParam().bytes, "m.ply"); }), "m.ply:" + GetParam().message);
}

const std::string kHead = "ply\nformat ascii 1.0\n";

INSTANTIATE_TEST_SUITE_P(
    Table, PlyError,
    testing::Values(
        Case{"Empty", "", "1: this is no PLY file: its first line is not \"ply\""},
        Case{"NoPly", "solid\n", "1: this is no PLY file: its first line is not \"ply\""},
        Case{"NoEnd", kHead + "element vertex 1\n",
             "3: the PLY header has no end_header line; is the file truncated?"},
        Case{"BadFormat", "ply\nformat ascii 2.0\n",
             "2: the PLY format must be ascii, binary_little_endian or binary_big_endian, version 1.0"},
        Case{"NoFormat", "ply\nend_header\n", "2: the PLY header has no format line"},
        Case{"BadCount", kHead + "element vertex -1\n",
             "3: a PLY element is written \"element NAME COUNT\", with a count of 0 or more"},
        Case{"BadType", kHead + "element vertex 1\nproperty flaot x\n", "4: unknown PLY type \"flaot\""},
        Case{"BadProperty", kHead + "element vertex 1\nproperty x\n",
             "4: a PLY property is written \"property TYPE NAME\" or \"property list TYPE TYPE NAME\""},
        Case{"FloatLength", kHead + "element face 1\nproperty list float int vertex_indices\n",
             "4: the length of a PLY list must be of an integer type"},
        Case{"StrayProperty", kHead + "property float x\n", "3: this property stands before any element"},
        Case{"UnknownWord", kHead + "elemnt vertex 1\n", "3: unknown word \"elemnt\" in a PLY header"},
        Case{"NoProperties", kHead + "element vertex 99999999999\nend_header\n",
             " the PLY element \"vertex\" has no properties"},
        Case{"HugeVertices", ascii("1000000000", "1", "0 0 0\n"),
             " the header promises 1000000000 of \"vertex\", but the file is too short for them; is it "
             "truncated?"},
        Case{"HugeFaces", ascii("3", "18446744073709551615", "0 0 0 1 0 0 0 1 0\n"),
             " the header promises 18446744073709551615 of \"face\", but the file is too short for them; is "
             "it truncated?"},
        Case{"NoZ",
             kHead + "element vertex 0\nproperty float x\nproperty float y\nelement face 0\n" + kFace +
                 "end_header\n",
             " the PLY element \"vertex\" needs the properties x, y and z"},
        Case{"NoFaces", kHead + "element vertex 0\n" + kXyz + "end_header\n",
             " a PLY mesh has one element \"face\", this file has 0"},
        Case{"NoIndices",
             kHead + "element vertex 0\n" + kXyz + "element face 0\nproperty int a\nend_header\n",
             " the PLY element \"face\" needs a list property vertex_indices"},
        Case{"NaN", ascii("3", "1", "0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n"),
             " vertex 1: \"nan\" is not a finite number"},
        Case{"HugeFloat", ascii("3", "1", "0 0 0\n1 0 0\n0 1 -1e39\n3 0 1 2\n"),
             " vertex 2: z is not a finite number"},
        Case{"Word", ascii("3", "1", "0 0 0\n1 0 zero\n0 1 0\n3 0 1 2\n"),
             " vertex 1: \"zero\" is not a number"},
        Case{"Line", ascii("3", "1", "0 0 0\n1 0 0\n0 1 0\n2 0 1 0 0\n"),
             " face 0: a face needs 3 corners or more, this has 2"},
        Case{"Length", ascii("3", "1", "0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n"),
             " face 0: -3 is not the length of a list"},
        Case{"Fraction", ascii("3", "1", "0 0 0\n1 0 0\n0 1 0\n3 0 1.5 2\n"),
             " face 0: 1.5 is not the number of a vertex"},
        Case{"Negative", ascii("3", "1", "0 0 0\n1 0 0\n0 1 0\n3 0 -1 2\n"),
             " face 0: -1 is not the number of a vertex"},
        Case{"OutOfRange", ascii("3", "2", "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 3\n"),
             " triangle 1 names vertex 3, but there are only 3"},
        Case{"Truncated", ascii("3", "1", "0 0 0\n1 0 0\n0 1 0\n3 0 1\n"),
             " face 0: the file ends here; is it truncated?"}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(Ply, BinaryNaNIsAnError) {
  Writer w("binary_little_endian");
  w.header("element vertex 1\n" + kXyz + "element face 0\n" + kFace).put(0.0f).put(std::nanf("")).put(0.0f);
  EXPECT_EQ(error_of([&] { parse_ply(w.bytes(), "m.ply"); }), "m.ply: vertex 0: y is not a finite number");
}

}  // namespace
}  // namespace capcon
