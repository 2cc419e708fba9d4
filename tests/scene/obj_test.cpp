#include <gtest/gtest.h>

#include "scene/obj_reader.h"
#include "scene_text.h"

namespace capcon {
namespace {

using test::error_of;

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST(Obj, FacesOfEveryForm) {
  const TriangleMesh mesh = parse_obj("# a comment\r\nmtllib none.mtl\r\no thing\r\ng group\r\n" + kSquare +
                                          "vt 0 0\nvt .5\nvn 0 0 1\nusemtl stone\ns off\nf 1 2 3\nf 1/1 2/2 "
                                          "3/1 4/2\n f\t-4//-1 -3//1 -1//1 \n"
                                          "f 1/1/1 2/2/1 3/-1/-1\nvp 1 2\nl 1 2\nunknown words\n",
                                      "m.obj");
  EXPECT_EQ(mesh.positions.size(), 4u);
  const std::vector<glm::uvec3> expected = {{0, 1, 2}, {0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {0, 1, 2}};
  EXPECT_EQ(mesh.triangles, expected);
  EXPECT_TRUE(mesh.normals.empty() && mesh.uvs.empty());
}

TEST(Obj, NegativeIndicesCountFromTheFace) {
  const TriangleMesh mesh = parse_obj(kSquare + "f -4 -3 -2\nv 9 9 9\nf -1 -2 -3\n", "m.obj");
  const std::vector<glm::uvec3> expected = {{0, 1, 2}, {4, 3, 2}};
  EXPECT_EQ(mesh.triangles, expected);
}

TEST(Obj, CornersSplitWhereNormalsOrUvsDiffer) {
  const std::string text =
      kSquare + "vt 0 0\nvt 1 1\nvn 0 0 1\nvn 1 0 0\nf 1/1/1 2/1/1 3/1/1\nf 1/1/1 3/2/1 4/1/2\n";
  const TriangleMesh both = parse_obj(text, "m.obj", {true, true});
  EXPECT_EQ(both.positions.size(), 5u) << "vertex 3 has two texture coordinates";
  EXPECT_EQ(both.triangles[1], glm::uvec3(0, 3, 4));
  EXPECT_EQ(both.positions[3], glm::vec3(1, 1, 0));
  EXPECT_EQ(both.uvs[3], glm::vec2(1, 1));
  EXPECT_EQ(both.normals[4], glm::vec3(1, 0, 0));
  const TriangleMesh normals = parse_obj(text, "m.obj", {true, false});
  EXPECT_EQ(normals.positions.size(), 4u);
  EXPECT_EQ(normals.normals.size(), 4u);
  const TriangleMesh some = parse_obj(text + "f 1 2 3\n", "m.obj", {true, true});
  EXPECT_EQ(some.positions.size(), 4u) << "not every corner has them, so none is kept";
  EXPECT_TRUE(some.normals.empty() && some.uvs.empty());
}

struct Case {
  const char* name;
  std::string text;
  const char* message;
};

class ObjError : public testing::TestWithParam<Case> {};

TEST_P(ObjError, SaysWhereAndWhat) {
  EXPECT_EQ(error_of([] { parse_obj(GetParam().text, "m.obj"); }),
            std::string("m.obj:") + GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Table, ObjError,
    testing::Values(
        Case{"FewNumbers", "v 1 2\n", "1: \"v\" needs 3 numbers"},
        Case{"NoNumber", "\nv 1 two 3\n", "2: \"two\" is not a number"},
        Case{"NaN", "v 1 nan 3\n", "1: \"nan\" is not a finite number"},
        Case{"HugeFloat", "v 1 1e39 3\n", "1: \"1e39\" is not a finite number"},
        Case{"FewCorners", kSquare + "f 1 2\n", "5: a face needs 3 corners or more"},
        Case{"Zero", kSquare + "f 0 1 2\n", "5: this face names v number 0, but 4 are defined so far"},
        Case{"TooLarge", kSquare + "f 1 2 5\n", "5: this face names v number 5, but 4 are defined so far"},
        Case{"TooNegative", kSquare + "f 1 2 -5\n",
             "5: this face names v number -5, but 4 are defined so far"},
        Case{"NoUv", kSquare + "f 1/1 2/1 3/1\n", "5: this face names vt number 1, but 0 are defined so far"},
        Case{"NoNormal", kSquare + "f 1//2 2//1 3//1\n",
             "5: this face names vn number 2, but 0 are defined so far"},
        Case{"Overflow", kSquare + "f 1 2 99999999999999999999\n",
             "5: \"99999999999999999999\" is not a corner; write v, v/vt, v//vn or v/vt/vn"},
        Case{"Word", kSquare + "f 1 2 c\n", "5: \"c\" is not a corner; write v, v/vt, v//vn or v/vt/vn"},
        Case{"FourParts", kSquare + "f 1 2 3////\n",
             "5: \"3////\" is not a corner; write v, v/vt, v//vn or v/vt/vn"},
        Case{"NoVertex", kSquare + "f 1 2 /1\n",
             "5: \"/1\" is not a corner; write v, v/vt, v//vn or v/vt/vn"}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace capcon
