#include "shading/scene_check.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "base/file.h"

namespace capcon {
namespace {

using testing::HasSubstr;

class SceneCheckTest : public ::testing::Test {
 protected:
  SceneCheckTest() { std::filesystem::create_directories(folder_); }
  ~SceneCheckTest() override { std::filesystem::remove_all(folder_); }
  SceneCheck check(const std::string& text) const {
    write_file(folder_ / "s.pbrt", text);
    return check_scene((folder_ / "s.pbrt").string());
  }
  const std::filesystem::path folder_ =
      std::filesystem::temp_directory_path() / ("capcon_check_" + std::to_string(::getpid()));
};

/// The note whose sentence holds these words; one that is easy to see in a failure where there is none.
SceneNote find(const SceneCheck& check, const std::string& words) {
  for (const SceneNote& note : check.notes.all()) {
    if (note.sentence.find(words) != std::string::npos) return note;
  }
  return {NoteKind::unused, "no note of \"" + words + "\"", {}, 0};
}

// Whatever is not rendered as it stands there is named, with its line and how often.
TEST_F(SceneCheckTest, NothingThatIsNotSupportedIsPassedOver) {
  const SceneCheck result = check(R"(Option "bool wavefront" true
ColorSpace "rec2020"
Film "gbuffer" "integer xresolution" 40 "float iso" 100 "float lensflare" 1 "integer pixelbounds" [0 1 0 1]
PixelFilter "gaussian"
Sampler "halton"
Integrator "volpath"
Accelerator "bvh"
TransformTimes 0 1
Camera "perspective" "float fov" 40 "float lensradius" 0.1 "float focaldistance" 2 "float shutterclose" 1
MakeNamedMedium "fog" "string type" "homogeneous"
WorldBegin
Attribute "medium" "float g" 0.5
Attribute "shape" "float shadowalpha" 0.5
MediumInterface "fog" ""
ActiveTransform EndTime
Translate 1 0 0
ActiveTransform All
Texture "t" "spectrum" "marble"
Texture "chess" "spectrum" "checkerboard"
LightSource "infinite" "point3 portal" [0 0 0 1 0 0 1 1 0 0 1 0] "float brightness" 2
LightSource "spot" "float coneangle" 20
LightSource "laser"
AreaLightSource "diffuse" "rgb L" [1 1 1] "integer nsamples" 4 "string filename" "light.exr"
Shape "sphere"
Material "dielectric"
Shape "curve"
Shape "curve"
Shape "sphere" "float radius" 1 "float raduis" 3
Material "glass"
Material "glass"
Material "diffuse" "texture reflectance" "t" "normal wobble" [0 0 1] "texture displacement" "t"
Material "diffuse" "texture reflectance" "chess"
Material "unobtainium"
Shape "loopsubdiv" "point3 P" [0 0 0 1 0 0 0 1 0] "integer levels" 3
Shape "trianglemesh" "point3 P" [0 0 0 1 0 0 0 1 0] "vector3 S" [0 0 0 0 0 0 0 0 0] "texture alpha" "t"
Shape "plymesh" "string filename" "none.ply"
NamedMaterial "missing"
ObjectBegin "o"
AreaLightSource "diffuse"
Shape "disk"
ObjectEnd
ObjectInstance "o"
)");
  EXPECT_TRUE(result.notes.errors.empty()) << result.notes.errors.front();
  EXPECT_TRUE(result.can_be_shaded()) << result.shading_errors.front();
  struct Expected {
    const char* words;
    int line;
    std::uint64_t count;
    NoteKind kind;
  };
  constexpr NoteKind a = NoteKind::approximated, l = NoteKind::left_out, u = NoteKind::unused;
  const Expected all[] = {
      {"Option \"wavefront\"", 1, 1, u},
      {"colour space \"rec2020\"", 2, 1, l},
      {"film \"gbuffer\"", 3, 1, u},
      {"\"iso\" of Film", 3, 1, u},
      {"\"lensflare\" of Film \"gbuffer\" is not known", 3, 1, u},
      {"crop is left out", 3, 1, l},
      {"PixelFilter \"gaussian\"", 4, 1, u},
      {"Sampler \"halton\"", 5, 1, u},
      {"Integrator \"volpath\"", 6, 1, u},
      {"Accelerator \"bvh\"", 7, 1, u},
      {"TransformTimes", 8, 1, u},
      {"depth of field is left out", 9, 1, l},
      {"\"focaldistance\" of Camera", 9, 1, u},
      {"\"shutterclose\" of Camera", 9, 1, u},
      {"media are left out", 10, 3, l},
      {"motion is left out", 15, 1, l},
      {"textures \"marble\" are constants", 18, 1, a},
      {"\"portal\" of LightSource", 20, 1, u},
      {"\"brightness\" of LightSource \"infinite\" is not known", 20, 1, u},
      {"this spot light is a point light", 21, 1, a},
      {"lights of the kind \"laser\" are left out", 22, 1, l},
      {"\"nsamples\" of AreaLightSource", 23, 1, u},
      {"images on area lights are left out", 23, 1, l},
      {"\"shadowalpha\" of Shape \"sphere\"", 13, 2, u},
      {"material \"dielectric\": what it transmits", 25, 1, a},
      {"shape \"curve\" is not supported", 26, 2, l},
      {"\"raduis\" of Shape \"sphere\" is not known and not used; did you mean \"radius\"?", 28, 1, u},
      {"material \"glass\": what it transmits", 29, 2, a},
      {"\"wobble\" of Material \"diffuse\" is not known", 31, 1, u},
      {"its bumps are left out", 31, 1, a},
      {"its texture \"marble\" is the constant", 31, 1, a},
      {"its texture \"checkerboard\" is the constant", 32, 1, a},
      {"there is no such material", 33, 1, a},
      {"subdivision surfaces are not refined", 34, 1, a},
      {"\"levels\" of Shape", 34, 1, u},
      {"\"S\" of Shape", 35, 1, u},
      {"alpha textures are left out", 35, 1, l},
      {"none.ply\" cannot be found", 36, 1, l},
      {"no material named \"missing\"", 37, 1, a},
      {"area lights in objects are left out", 40, 1, l},
  };
  for (const Expected& e : all) {
    const SceneNote note = find(result, e.words);
    EXPECT_THAT(note.sentence, HasSubstr(e.words));
    EXPECT_EQ(note.place.line, e.line) << note.sentence;
    EXPECT_EQ(note.count, e.count) << note.sentence;
    EXPECT_EQ(note.kind, e.kind) << note.sentence;
  }
  EXPECT_EQ(result.lights, 6u);  // infinite, point, and four shapes that have the area light
}

// What stops a render is listed whole, and the first is what the render itself says.
TEST_F(SceneCheckTest, ReadingGoesOnBehindErrors) {
  const std::string text =
      "Camera \"realistic\" \"string lensfile\" \"wide.dat\"\nWorldBegin\nShap \"sphere\"\n"
      "Shape \"sphere\" \"float radius\" -1\nShape \"cube\"\nShape \"disk\"\nAttributeBegin\n";
  const SceneCheck result = check(text);
  ASSERT_EQ(result.notes.errors.size(), 5u);
  EXPECT_THAT(result.notes.errors[0], HasSubstr("s.pbrt:1:1: camera \"realistic\" is not supported"));
  EXPECT_THAT(result.notes.errors[1],
              HasSubstr("s.pbrt:3:1: unknown directive \"Shap\"; did you mean \"Shape\"?"));
  EXPECT_THAT(result.notes.errors[2], HasSubstr("s.pbrt:4:"));
  EXPECT_THAT(result.notes.errors[3], HasSubstr("s.pbrt:5:1: unknown shape \"cube\""));
  EXPECT_THAT(result.notes.errors[4], HasSubstr("s.pbrt:7:1: this AttributeBegin is never closed"));
  EXPECT_EQ(result.scene.shapes.size(), 1u);
  EXPECT_FALSE(result.can_be_seen());
  try {
    read_scene((folder_ / "s.pbrt").string());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), result.notes.errors[0]);
  }
}

TEST_F(SceneCheckTest, ABrokenMaterialStopsShadingAlone) {
  const SceneCheck result = check(
      "Camera \"perspective\"\nWorldBegin\nMaterial \"diffuse\" \"texture reflectance\" \"none\"\n"
      "Shape \"sphere\"\n");
  EXPECT_TRUE(result.can_be_seen());
  EXPECT_FALSE(result.can_be_shaded());
  EXPECT_THAT(result.shading_errors.at(0), HasSubstr("s.pbrt:3:20: there is no texture named \"none\""));
}

// The shipped scenes ask for nothing that they do not get.
TEST_F(SceneCheckTest, ShippedScenesAreRenderedAsTheyStand) {
  for (const char* name : {"courtyard", "nave", "direct"}) {
    const SceneCheck result = check_scene(shipped_file(std::string("scenes/") + name + ".pbrt").string());
    EXPECT_TRUE(result.can_be_shaded() && result.lights > 0) << name;
    for (const SceneNote& note : result.notes.all())
      EXPECT_EQ(note.kind, NoteKind::unused) << name << " " << note.sentence;
  }
}

}  // namespace
}  // namespace capcon
