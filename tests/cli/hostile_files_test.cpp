// Files that claim what they do not hold: one sentence, exit code 2, at once and in little memory.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "cli/program.h"

namespace capcon::testing {
namespace {

/// 1 GiB of address space, 10 seconds of wall time.
const char* const kLimits = "ulimit -v 1048576; timeout 10 env CAPCON_THREADS=2";

void expect_refused(const std::string& words, const std::vector<std::string>& expected,
                    const std::string& environment = "") {
  const Outcome outcome = run(words, kLimits + environment);
  EXPECT_EQ(outcome.exit_code, 2) << words << "\n" << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  for (const std::string& word : expected)
    EXPECT_NE(outcome.err.find(word), std::string::npos) << "no \"" << word << "\" in: " << outcome.err;
}

std::string render(const std::string& file) {
  return "render " + file + " --device reference --quiet --radius 1 -o /tmp/capcon-never.exr";
}

/// The lowest byte first.
template <class T>
std::string bytes_of(std::initializer_list<T> values) {
  std::string bytes;
  for (const T value : values) bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  return bytes;
}

std::string big_endian(std::uint32_t value) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xff);
  return bytes;
}

std::string png_of_size(std::uint32_t width, std::uint32_t height) {
  using namespace std::string_literals;
  return "\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR"s + big_endian(width) + big_endian(height) + "\x08\x02\0\0\0CRC4"s +
         "\0\0\0\x08IDAT\x78\x9c\x03\0\0\0\0\x01"s + "CRC4\0\0\0\0IENDCRC4"s;
}

/// A copy of a small EXR that the program wrote, with another data window.
std::string exr_of_size(std::string bytes, std::int32_t width, std::int32_t height) {
  using namespace std::string_literals;
  const std::string name = "dataWindow\0box2i\0"s;
  const std::size_t at = bytes.find(name) + name.size() + 4 + 8;
  return bytes.replace(at, 8, bytes_of({width - 1, height - 1}));
}

TEST(HostileFiles, Includes) {
  const Folder folder;
  folder.write("a.pbrt", "Include \"b.pbrt\"\n");
  folder.write("b.pbrt", "\nInclude \"a.pbrt\"\n");
  expect_refused(render(folder / "a.pbrt"), {"b.pbrt:2:1: ", "circle"});
  expect_refused(render(folder.write("self.pbrt", "Include \"self.pbrt\"\n")), {"self.pbrt:1:1: ", "circle"});
  for (int i = 0; i < 100; ++i)
    folder.write("deep" + std::to_string(i) + ".pbrt",
                 "Include \"deep" + std::to_string(i + 1) + ".pbrt\"\n");
  expect_refused(render(folder / "deep0.pbrt"), {".pbrt:1:1: ", "deep"});
}

TEST(HostileFiles, PlyHeaders) {
  const Folder folder;
  const auto ply = [&](const std::string& vertices, const std::string& faces) {
    return render(folder.write(
        "m.ply", "ply\nformat binary_little_endian 1.0\nelement vertex " + vertices +
                     "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
                     "\nproperty list uchar int vertex_indices\nend_header\n" + std::string(36, '\0')));
  };
  expect_refused(ply("1000000000", "1"), {"m.ply: ", "1000000000", "too short"});
  expect_refused(ply("1000000000000000000", "1"), {"m.ply: ", "too short"});
  expect_refused(ply("18446744073709551615", "1"), {"m.ply: ", "too short"});
  expect_refused(ply("3", "1000000000"), {"m.ply: ", "\"face\"", "too short"});
  expect_refused(ply("18446744073709551616", "1"), {"m.ply:3: ", "element"});
  expect_refused(ply("-3", "1"), {"m.ply:3: ", "element"});
}

TEST(HostileFiles, ObjIndices) {
  const Folder folder;
  for (const char* index : {"4294967297", "9223372036854775807", "-9223372036854775808"}) {
    const std::string text = std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 ") + index + "\n";
    expect_refused(render(folder.write("m.obj", text)), {"m.obj:4: ", index});
  }
  expect_refused(render(folder.write("m.obj", "v 0 0 0\nf 1 1 99999999999999999999\n")), {"m.obj:2: "});
}

TEST(HostileFiles, Images) {
  const Folder folder;
  const std::string density = "points random -n 4 -o /tmp/capcon-never.txt --density ";
  expect_refused(density + folder.write("i.png", png_of_size(100000, 100000)), {"i.png: "});
  expect_refused(density + folder.write("i.png", png_of_size(8192, 8192)), {"i.png: ", "too short"});
  expect_refused(density + folder.write("i.png", png_of_size(0xffffffff, 0xffffffff)), {"i.png: "});
  std::string cut = png_of_size(1, 1);
  expect_refused(density + folder.write("i.png", cut.replace(33, 4, big_endian(0x7fffffff))),
                 {"i.png: ", "cut short"});

  const std::string good = contents(std::string(CAPCON_SOURCE_DIR) + "/tests/fuzz/corpus/exr/grey.exr");
  ASSERT_GT(good.size(), 100u);
  const std::string file = folder.write("i.exr", exr_of_size(good, 100000, 100000));
  expect_refused("compare " + file + " " + file, {"i.exr: ", "100000 x 100000"});
  folder.write("i.exr", exr_of_size(good, 16384, 16384));
  expect_refused("compare " + file + " " + file, {"i.exr: ", "too short"});
  folder.write("i.exr", exr_of_size(good, -2147483647, 1));
  expect_refused("compare " + file + " " + file, {"i.exr: "});
}

TEST(HostileFiles, BrdfTables) {
  const Folder folder;
  const std::string scene = folder.write("s.pbrt",
                                         "WorldBegin\nLightSource \"point\"\nMaterial \"measured\" \"string "
                                         "filename\" \"t.binary\"\nShape \"sphere\"\n");
  const std::string words =
      "render " + scene + " --integrator direct --device reference --quiet -o /tmp/capcon-never.exr";
  folder.write("t.binary", bytes_of({4096, 4096, 4096}) + std::string(24, '\0'));
  expect_refused(words, {"t.binary: ", "4096 x 4096 x 4096"});
  folder.write("t.binary", bytes_of({2147483647, 2147483647, 2147483647}) + std::string(24, '\0'));
  expect_refused(words, {"t.binary: ", "MERL"});
  folder.write("t.binary", bytes_of({-1, 90, 180}));
  expect_refused(words, {"t.binary: ", "MERL"});
}

TEST(HostileFiles, TilesAndPoints) {
  const Folder folder;
  const std::string verify = "tiles verify ";
  expect_refused(verify + folder.write("t.tiles", "capcon-tiles 1\ncolours 8\npoints 4096\nrecipe x\n"),
                 {"t.tiles:5: "});
  expect_refused(verify + folder.write("t.tiles", "capcon-tiles 1\ncolours 4294967295\npoints 1\n"),
                 {"t.tiles:2: ", "1 to 8"});
  expect_refused(verify + folder.write("t.tiles", "capcon-tiles 1\ncolours 2\npoints 1e9\n"),
                 {"t.tiles:3: "});
  const std::uint32_t most = 0xffffffff;
  const std::string head = "CAPENSEM" + bytes_of<std::uint32_t>({1, 0, 1});
  expect_refused("ensembles show " +
                     folder.write("e", head + bytes_of({most, most, most, most}) + std::string(24, '\0')),
                 {"/e: ", "sizes"});
  expect_refused(
      "ensembles show " + folder.write("e", head + bytes_of<std::uint32_t>({1u << 22, 2048, 2048, 1u << 22}) +
                                                std::string(24, '\0')),
      {"/e: ", "cut short"});
  expect_refused("points import " + folder.write("p.bin", bytes_of({0x214B5455u, 4u, most, most, 2u}) +
                                                              std::string(16, '\0')),
                 {"p.bin: ", "4294967295"});
}

/// FNV-1a, 64 bits.
std::uint64_t checksum(const std::string& bytes) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  return hash;
}

TEST(HostileFiles, PartsOfTiles) {
  const Folder folder;
  std::filesystem::create_directory(folder / "tiles");
  std::filesystem::copy_file(std::string(CAPCON_SOURCE_DIR) + "/tiles/c2n16.tiles",
                             folder / "tiles/c2n16.tiles");
  const std::string scene =
      folder.write("s.pbrt", "WorldBegin\nLightSource \"point\"\nTranslate 0 0 3\nShape \"sphere\"\n");
  const std::uint32_t most = 0xffffffff;
  for (const std::string& splits :
       {bytes_of<std::uint32_t>({most}), bytes_of<std::uint32_t>({1, 16, 2, most, most, most}),
        bytes_of<std::uint32_t>({1, most, most, 0, 0, 1}),
        bytes_of<std::uint32_t>({1, 16, 2, 4096, 256, 1})}) {
    std::string parts = "CAPPARTS" + bytes_of<std::uint32_t>({1, 0, 0}) + splits;
    folder.write("tiles/c2n16.parts", parts + bytes_of({checksum(parts)}));
    expect_refused("render " + scene +
                       " --integrator direct --split 2x8 --sampler capcon --device reference --quiet -o "
                       "/tmp/capcon-never.exr",
                   {"c2n16.parts: "}, " CAPCON_DATA=" + (folder / ""));
  }
}

TEST(HostileFiles, RunsOfAStudy) {
  const Folder folder;
  const std::string scene = folder.write("s.pbrt",
                                         "Film \"rgb\" \"integer xresolution\" 4 \"integer yresolution\" "
                                         "4\nWorldBegin\nTranslate 0 0 3\nShape \"sphere\"\n");
  const std::string head = "{\"settings_hash\":\"0\",\"started\":\"now\"}\n";
  const auto line = [](const std::string& samples, const std::string& mse) {
    return "{\"sampler\":\"random\",\"samples\":" + samples + ",\"seed\":1,\"mse\":" + mse +
           ",\"mse_trimmed\":0,\"relmse\":0,\"rays\":1,\"device_seconds\":0,\"wall_seconds\":0,"
           "\"point_generation_seconds\":0,\"timings\":{\"wall\":{},\"device\":{}},\"device\":\"x\"}\n";
  };
  const std::string words =
      "study ambient-occlusion " + scene + " --device reference --quiet -o " + (folder / "");
  for (const std::string& wrong :
       {line("1e300", "0"), line("-1", "0"), line("0", "0"), line("4294967296", "0"), line("\"1\"", "0"),
        line("1", "NaN"), line("1", "-1"), line("1", "1e999"), line("1", "null"), line("1", "[]")}) {
    folder.write("runs.jsonl", head + line("1", "0") + wrong);
    expect_refused(words, {"runs.jsonl:3: ", "--fresh"});
  }
  folder.write("runs.jsonl", "{\"settings_hash\":\"0\",\"started\":[1]}\n");
  expect_refused(words, {"runs.jsonl:1: ", "header"});
  folder.write("runs.jsonl", "{\"settings_hash\":\"0\",\"x\":" + std::string(1'000'000, '[') + "\n");
  expect_refused(words, {"runs.jsonl:1: ", "header"});
}

}  // namespace
}  // namespace capcon::testing
