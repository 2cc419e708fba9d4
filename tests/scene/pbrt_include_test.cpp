#include <gtest/gtest.h>

#include "scene_text.h"

namespace capcon {
namespace {

using test::error_of;
using test::Folder;

TEST(PbrtInclude, IsTheTextOfTheOtherFile) {
  const Folder folder;
  folder.write("parts/move.pbrt", "Translate 1 0 0");
  const std::string main = folder.write(
      "main.pbrt", "WorldBegin Include \"parts/move.pbrt\" Include \"parts/move.pbrt\" Shape \"sphere\"");
  EXPECT_EQ(read_scene(main).shapes.at(0).to_world[3].x, 2);
}

TEST(PbrtInclude, NamesAreRelativeToTheMainFileThenToTheIncludingOne) {
  const Folder folder;
  folder.write("parts/a.pbrt", "Include \"b.pbrt\" Include \"parts/b.pbrt\" Include \"c.pbrt\"");
  folder.write("parts/b.pbrt", "Translate 1 0 0");
  folder.write("parts/c.pbrt", "Translate 0 1 0");
  folder.write("c.pbrt", "Translate 0 0 1");
  const std::string main = folder.write("main.pbrt", "WorldBegin Include \"parts/a.pbrt\" Shape \"sphere\"");
  EXPECT_EQ(read_scene(main).shapes.at(0).to_world[3], glm::dvec4(2, 0, 1, 1))
      << "c.pbrt beside the main file comes first";
}

TEST(PbrtInclude, ImportKeepsItsChangesToItself) {
  const Folder folder;
  folder.write("a.pbrt",
               "Translate 1 0 0 Material \"metal\" Shape \"sphere\" MakeNamedMaterial \"m\" \"string type\" "
               "\"glass\"");
  const Scene scene = read_scene(folder.write(
      "main.pbrt", "WorldBegin Import \"a.pbrt\" Shape \"sphere\" NamedMaterial \"m\" Shape \"sphere\""));
  EXPECT_EQ(scene.shapes.at(0).to_world[3].x, 1);
  EXPECT_EQ(scene.shapes.at(1).to_world[3].x, 0);
  EXPECT_EQ(scene.shapes.at(1).material, -1);
  EXPECT_EQ(scene.materials.at(scene.shapes.at(2).material).type, "glass");
}

TEST(PbrtInclude, PlacesNameTheIncludedFile) {
  const Folder folder;
  const std::string part = folder.write("part.pbrt", "# fine\n  Oops");
  const std::string main = folder.write("main.pbrt", "WorldBegin Include \"part.pbrt\"");
  EXPECT_EQ(error_of([&] { read_scene(main); }), part + ":2:3: unknown directive \"Oops\"");
}

TEST(PbrtInclude, CirclesAreErrors) {
  const Folder folder;
  const std::string a = folder.write("a.pbrt", "Include \"b.pbrt\"");
  const std::string b = folder.write("b.pbrt", "\nInclude \"./a.pbrt\"");
  EXPECT_EQ(error_of([&] { read_scene(a); }),
            b + ":2:1: \"" + folder.path("./a.pbrt") +
                "\" is included while it is being read: the files include each other in a circle");
}

TEST(PbrtInclude, SixtyFourDeepIsTheEnd) {
  const Folder folder;
  const auto chain = [&](int length) {
    for (int i = 0; i < length; ++i) {
      folder.write(std::to_string(i) + ".pbrt", "Include \"" + std::to_string(i + 1) + ".pbrt\"");
    }
    folder.write(std::to_string(length) + ".pbrt", "WorldBegin Shape \"sphere\"");
    return folder.path("0.pbrt");
  };
  EXPECT_EQ(read_scene(chain(64)).shapes.size(), 1u);
  EXPECT_EQ(error_of([&] { read_scene(chain(65)); }),
            folder.path("64.pbrt") + ":1:1: files are included more than 64 deep");
}

}  // namespace
}  // namespace capcon
