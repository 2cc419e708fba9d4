#include <gtest/gtest.h>

#include "scene_text.h"

namespace capcon {
namespace {

struct Case {
  const char* name;
  const char* text;
  const char* message;
};

class PbrtError : public testing::TestWithParam<Case> {};

TEST_P(PbrtError, SaysWhereAndWhat) {
  std::string expected = "s.pbrt:";
  expected += GetParam().message;
  EXPECT_EQ(test::error_of([] { test::parse(GetParam().text); }), expected);
}

#define MESH "WorldBegin\nShape \"trianglemesh\" \"point3 P\" [0 0 0 1 0 0 0 1 0"

const Case kCases[] = {
    {"UnknownDirective", "WorldBegin\n  Shpae \"sphere\"",
     "2:3: unknown directive \"Shpae\"; did you mean \"Shape\"?"},
    {"UnknownDirectiveAlone", "Qwertyuiop 1 2", "1:1: unknown directive \"Qwertyuiop\""},
    {"NumberAsDirective", "WorldBegin 12", "1:12: unknown directive \"12\""},
    {"StringAsDirective", "WorldBegin\r\n \"float x\" 1", "2:2: a directive is wanted here, not \"float x\""},
    {"UnclosedString", "WorldBegin\nShape \"sphere\n",
     "2:7: this string is not closed on its line; put a \" at its end"},
    {"UnclosedBracket", "Camera \"perspective\" \"float fov\" [ 40\n",
     "1:34: this [ is never closed; put a ] behind the last value of \"float fov\""},
    {"NoValue", "Camera \"perspective\" \"float fov\"",
     "1:33: \"float fov\" has no value: the file ends here"},
    {"WordForNumber", "Camera \"perspective\" \"float fov\" [ wide ]",
     "1:36: \"float fov\" wants a number here, not \"wide\""},
    {"StringForNumber", "Camera \"perspective\" \"float fov\" \"40\"",
     "1:34: \"float fov\" wants a number here, not \"40\""},
    {"NumberForString", "Film \"rgb\" \"string filename\" 7",
     "1:30: \"string filename\" wants a quoted string here, not \"7\""},
    {"FractionForInteger", "Film \"rgb\" \"integer xresolution\" [ 1.5 ]",
     "1:36: \"integer xresolution\" wants a whole number here, not \"1.5\""},
    {"NotABoolean", "Option \"bool wavefront\" yes",
     "1:25: \"bool wavefront\" wants true or false here, not \"yes\""},
    {"UnknownType", "Camera \"perspective\" \"flaot fov\" 1",
     "1:22: unknown parameter type \"flaot\"; did you mean \"float\"?"},
    {"NoParameterName", "Camera \"perspective\" \"float\" 1",
     "1:22: a parameter is written \"type name\", not \"float\""},
    {"WrongGroup", "WorldBegin LightSource \"point\" \"rgb I\" [1 2]",
     "1:32: \"rgb I\" has 2 numbers, which is not a multiple of 3"},
    {"MixedSpectrum", "WorldBegin LightSource \"point\" \"spectrum I\" [ \"D65\" 1 ]",
     "1:53: \"spectrum I\" wants a quoted string here, not \"1\""},
    {"NotANumberCoordinate", MESH " 0 nan 0]", "2:54: \"point3 P\" wants a finite number here, not \"nan\""},
    {"InfiniteCoordinate", MESH "\n-inf]", "3:1: \"point3 P\" wants a finite number here, not \"-inf\""},
    {"HugeCoordinate", MESH " 0 0 1e400]", "2:56: \"point3 P\" wants a finite number here, not \"1e400\""},
    {"HugeFloat", MESH " 0 0 1e40]", "2:22: \"P\" number 11 is too large for a float"},
    {"IndexOutOfRange", MESH "]\n\"integer indices\" [0 1 3]",
     "3:1: number 2 of \"integer indices\" is 3, but the vertices are numbered 0 to 2"},
    {"NegativeIndex", MESH "]\n\"integer indices\" [0 1 -1]",
     "3:1: number 2 of \"integer indices\" is -1, but the vertices are numbered 0 to 2"},
    {"IndexCount", MESH "]\n \"integer indices\" [0 1]",
     "3:2: \"integer indices\" has 2 numbers, which is not a multiple of 3"},
    {"NoIndices", MESH " 1 1 1]", "2:1: this mesh has no \"integer indices\""},
    {"NoPoints", "WorldBegin\nShape \"trianglemesh\" \"integer indices\" [0 1 2]",
     "2:1: this mesh has no \"point P\""},
    {"UnknownShape", "WorldBegin Shape \"spere\"", "1:12: unknown shape \"spere\"; did you mean \"sphere\"?"},
    {"BadRadius", "WorldBegin Shape \"sphere\" \"float radius\" 0",
     "1:27: radius must be greater than 0 and less than 1e18"},
    {"BadInnerRadius", "WorldBegin Shape \"disk\" \"float innerradius\" 1",
     "1:25: innerradius must be 0 or more and less than the radius"},
    {"MeshWithoutFile", "WorldBegin Shape \"plymesh\"", "1:12: a plymesh needs its \"string filename\""},
    {"MeshOfAnotherKind", "WorldBegin Shape \"plymesh\" \"string filename\" \"a.ply.gz\"",
     "1:28: a plymesh is read from a .ply file, not from \"a.ply.gz\""},
    {"FlatScale", "WorldBegin\nScale 1 0 1",
     "2:1: the current transform cannot be inverted from here on: it flattens space, or its numbers "
     "are too extreme"},
    {"FlatMatrix", "ConcatTransform [1 0 0 0 1 0 0 0 0 0 1 0 0 0 0 1]",
     "1:1: the current transform cannot be inverted from here on: it flattens space, or its numbers are too "
     "extreme"},
    {"ProjectiveMatrix", "Transform [1 0 0 0 0 1 0 0 0 0 1 1 0 0 0 1]",
     "1:1: Transform wants an affine matrix, column by column: its numbers 4, 8 and 12 are 0, its last is 1"},
    {"LookAlongUp", "LookAt 0 0 0 0 1 0 0 1 0",
     "1:1: LookAt needs an eye apart from its target, and an up that is not along the view"},
    {"NoAxis", "Rotate 30 0 0 0", "1:1: Rotate needs an axis that is not 0 0 0"},
    {"TooFewNumbers", "Translate 1 2\nWorldBegin", "2:1: Translate wants a number here, not \"WorldBegin\""},
    {"TooManyNumbers", "Scale [1 2 3 4]", "1:14: Scale wants 3 numbers and then a ], not \"4\""},
    {"UnknownSystem", "CoordSysTransform \"camera\"", "1:1: there is no coordinate system \"camera\""},
    {"BadActiveTransform", "ActiveTransform Begin",
     "1:17: ActiveTransform wants StartTime, EndTime or All, not \"Begin\""},
    {"OtherCamera", "Camera \"orthographic\"",
     "1:1: camera \"orthographic\" is not supported; use \"perspective\""},
    {"WideCamera", "Camera \"perspective\" \"float fov\" 180",
     "1:22: the field of view must lie between 0 and 180 degrees"},
    {"BadScreen", "Camera \"perspective\" \"float screenwindow\" [0 0 1 2]",
     "1:22: a screen window is four numbers: x_min x_max y_min y_max"},
    {"UnknownFilm", "Film \"imgae\"", "1:1: unknown film \"imgae\"; did you mean \"image\"?"},
    {"BadResolution", "Film \"rgb\" \"integer yresolution\" 0",
     "1:12: yresolution must be a whole number from 1 to 65536"},
    {"ShapeBeforeWorld", "Shape \"sphere\"", "1:1: Shape belongs behind WorldBegin"},
    {"CameraInWorld", "WorldBegin Camera \"perspective\"", "1:12: Camera belongs before WorldBegin"},
    {"SecondWorld", "WorldBegin WorldBegin", "1:12: this is the second WorldBegin; a scene has one world"},
    {"NoWorld", "Identity", " this scene has no WorldBegin"},
    {"UnclosedAttribute", "WorldBegin\n AttributeBegin",
     "2:2: this AttributeBegin is never closed; add its AttributeEnd"},
    {"UnclosedTransform", "WorldBegin TransformBegin WorldEnd",
     "1:12: this TransformBegin is never closed; add its TransformEnd"},
    {"UnclosedObject", "WorldBegin ObjectBegin \"o\"",
     "1:12: this ObjectBegin is never closed; add its ObjectEnd"},
    {"StrayAttributeEnd", "WorldBegin AttributeEnd", "1:12: AttributeEnd has no AttributeBegin before it"},
    {"StrayTransformEnd", "TransformEnd", "1:1: TransformEnd has no TransformBegin before it"},
    {"StrayObjectEnd", "WorldBegin AttributeBegin ObjectEnd", "1:27: ObjectEnd has no ObjectBegin before it"},
    {"NestedObject", "WorldBegin ObjectBegin \"a\" ObjectBegin \"b\"",
     "1:28: ObjectBegin inside an object; close the outer one with ObjectEnd first"},
    {"InstanceInObject", "WorldBegin ObjectBegin \"a\" ObjectInstance \"a\"",
     "1:28: ObjectInstance inside an object: objects hold shapes only"},
    {"UnknownObject", "WorldBegin ObjectBegin \"chair\" ObjectEnd ObjectInstance \"chairs\"",
     "1:42: there is no object named \"chairs\"; did you mean \"chair\"?"},
    {"MaterialWithoutType", "WorldBegin MakeNamedMaterial \"m\" \"float x\" 1",
     "1:12: the named material \"m\" needs its \"string type\""},
    {"TextureOfNothing", "WorldBegin Texture \"t\" \"int\" \"scale\"",
     "1:24: the texture \"t\" must be of \"float\" or \"spectrum\", not \"int\""},
    {"AttributeTarget", "WorldBegin Attribute \"shapes\" \"float radius\" 1",
     "1:12: Attribute knows no target \"shapes\"; did you mean \"shape\"?"},
    {"MissingInclude", "Include \"nowhere.pbrt\"", "1:1: the file \"nowhere.pbrt\" cannot be found"},
    {"PackedInclude", "Include \"a.pbrt.gz\"",
     "1:1: compressed files are not read; unpack \"a.pbrt.gz\" with gunzip"},
};

INSTANTIATE_TEST_SUITE_P(Table, PbrtError, testing::ValuesIn(kCases),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace capcon
