#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/program.h"
#include "image/image.h"

namespace capcon::testing {
namespace {

// A program that is not ours: every cell once over all sets, and the mean of x^2 + x y over sets and
// symmetries, whose integral over the square is 1/3 + 1/4 = 7/12, within what the cells' middles leave of it.
constexpr const char* kProgram = R"(#include "sets.h"
#include <stdio.h>
int main(void) {
  static int seen[CAPCON_SQUARE_9_COLUMNS * CAPCON_SQUARE_9_ROWS];
  double sum = 0;
  for (uint32_t s = 0; s < CAPCON_SQUARE_9_SETS; ++s)
    for (uint32_t i = 0; i < CAPCON_SQUARE_9_POINTS; ++i)
      for (uint32_t g = 0; g < 8; ++g) {
        float p[2];
        capcon_square_9(s, g, i, 0.5f, 0.5f, p);
        sum += (double)p[0] * p[0] + (double)p[0] * p[1];
        if (g == 0) ++seen[(int)(p[0] * CAPCON_SQUARE_9_COLUMNS) + CAPCON_SQUARE_9_COLUMNS * (int)(p[1] * CAPCON_SQUARE_9_ROWS)];
      }
  for (uint32_t c = 0; c < sizeof seen / sizeof *seen; ++c)
    if (seen[c] != 1) return 1;
  printf("%.6f\n", sum / (8.0 * CAPCON_SQUARE_9_SETS * CAPCON_SQUARE_9_POINTS));
  return 0;
}
)";

TEST(Export, ACProgramUsesTheSets) {
  const Folder folder;
  ASSERT_EQ(run("export -n 9 --domain square -o " + (folder / "sets.h")).exit_code, 0);
  const std::string source = folder.write("use.c", kProgram), result = folder / "out.txt";
  const std::string build = "cc -std=c99 -Wall -Wextra -Werror -o " + (folder / "use") + " " + source;
  ASSERT_EQ(std::system(build.c_str()), 0);
  ASSERT_EQ(std::system(((folder / "use") + " > " + result).c_str()), 0);
  EXPECT_NEAR(std::strtod(contents(result).c_str(), nullptr), 7.0 / 12, 1e-4);
}

TEST(Export, GlslCompiles) {
  const Folder folder;
  ASSERT_EQ(run("export -n 4 --domain cylinder -o " + (folder / "sets.glsl")).exit_code, 0);
  const std::string shader = folder.write(
      "use.comp",
      "#version 450\n" + contents(folder / "sets.glsl") +
          "layout(local_size_x = 64) in;\nlayout(set = 0, binding = 0) buffer B { vec2 points[]; };\n"
          "void main() { uint i = gl_GlobalInvocationID.x;\n"
          "  points[i] = capcon_cylinder_4(i % capcon_cylinder_4_sets, 3u, i % capcon_cylinder_4_points, "
          "vec2(0.5)); }\n");
  EXPECT_EQ(
      std::system(("glslangValidator -V -o " + (folder / "use.spv") + " " + shader + " > /dev/null").c_str()),
      0);
}

TEST(Export, NumPyAndExrHoldEveryCell) {
  const Folder folder;
  const Outcome o = run("export -n 16 --json -o " + (folder / "sets.npy"));
  ASSERT_EQ(o.exit_code, 0);
  const auto json = nlohmann::json::parse(o.out);
  const std::size_t sets = json.at("sets");
  const std::string bytes = contents(folder / "sets.npy");
  const std::size_t start = bytes.size() - sets * 16 * 4 * 8;
  EXPECT_EQ(start % 64, 0u);
  EXPECT_NE(bytes.substr(0, start).find("'shape': (" + std::to_string(sets) + ", 16, 4)"), std::string::npos);
  EXPECT_EQ(bytes[start - 1], '\n');
  std::set<std::pair<double, double>> corners;
  for (std::size_t k = 0; k < sets * 16; ++k) {
    double cell[4];
    std::memcpy(cell, &bytes[start + 32 * k], 32);
    corners.insert({cell[0], cell[1]});
    EXPECT_NEAR(cell[2] * cell[3] * double(sets) * 16, 1, 1e-12);
  }
  EXPECT_EQ(corners.size(), sets * 16);
  ASSERT_EQ(run("export -n 16 -o " + (folder / "sets.exr")).exit_code, 0);
  const Image image = read_exr(folder / "sets.exr");
  EXPECT_EQ(image.width, 16);
  EXPECT_EQ(image.height, int(sets));
  for (int s = 0; s < image.height; ++s)
    for (int i = 0; i < 16; ++i) EXPECT_EQ(corners.count({image.at(i, s, 0), image.at(i, s, 1)}), 1u);
}

TEST(Export, OtherFilesAreRefused) {
  const Folder folder;
  const Outcome o = run("export -o " + (folder / "sets.txt"));
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_NE(o.err.find(".h (C), .glsl, .npy (NumPy) or .exr"), std::string::npos);
  EXPECT_EQ(run("export -n 5000 -o " + (folder / "sets.h")).exit_code, 2);
}

TEST(Screen, BlueIsCapconScreen) {
  const Folder folder;
  const std::string scene = folder.write("s.pbrt",
                                         "Camera \"perspective\" \"float fov\" 40\nFilm \"rgb\" \"integer "
                                         "xresolution\" 24 \"integer yresolution\" 16\n"
                                         "WorldBegin\nTranslate 0 0 4\nShape \"sphere\"\nShape \"disk\" "
                                         "\"float radius\" 5 \"float height\" 1\n");
  const std::string words = "render " + scene + " --radius 2 --samples 4 --quiet ";
  ASSERT_EQ(run(words + "--screen blue -o " + (folder / "a.exr")).exit_code, 0);
  ASSERT_EQ(run(words + "--sampler capcon-screen -o " + (folder / "b.exr")).exit_code, 0);
  EXPECT_EQ(read_exr(folder / "a.exr").pixels, read_exr(folder / "b.exr").pixels);
  EXPECT_EQ(run(words + "--screen blue --sampler sobol-owen -o " + (folder / "c.exr")).exit_code, 2);
  EXPECT_EQ(run("render " + scene + " --samples 300 --screen blue -o " + (folder / "c.exr")).exit_code, 2);
}

}  // namespace
}  // namespace capcon::testing
