#include "points/import_points.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "base/error.h"
#include "base/file.h"

namespace capcon {
namespace {

std::string csv_message(const std::string& text) {
  try {
    parse_csv_points(text, "p.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string binary_message(const std::string& bytes) {
  try {
    parse_binary_points(bytes, "p.bin");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ImportCsv, ReadsTheUsualKinds) {
  const std::vector<Points> expected{{{0.25, 0.5}, {0, 0.75}}};
  for (const char* text : {
           "0.25,0.5\n0,0.75\n",
           "x,y\n0.25, 0.5\n\n1 ,7.5e-1",
           "\xef\xbb\xbf\"x\";\"y\"\r\n0,25;0,5\r\n0;0,75\r\n",
           "0.25;0.5\n0;+0.75",
           "x   y\n0.25 0.5\n0\t0.75\n",
           "\"0.25\",\"0.5\"\n-0,0.75\n",
       })
    EXPECT_EQ(parse_csv_points(text, "p.csv"), expected) << text;
}

TEST(ImportCsv, SaysWhereAndWhatIsWrong) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "p.csv: holds no points"},
      {"x,y\n", "p.csv: holds no points"},
      {"0,0\nx,y\n", "p.csv:2: \"x\" is not a number"},
      {"0,0\n\n0.5\n", "p.csv:3: 1 column where two"},
      {"0,0,0\n", "p.csv:1: 3 columns where two"},
      {"x,y\n0,1.5\n", "p.csv:2: 1.5 is not in [0, 1]"},
      {"x,y\n0,nan\n", "p.csv:2: nan is not in [0, 1]"},
      {"0,1e999\n", "p.csv:1: 1e999 is not in [0, 1]"},
      {"0.5,y\n", "p.csv:1: \"y\" is not a number"},
      {"a,b\nc,d\n", "p.csv:2: \"c\" is not a number"},
      {"0;0\n0,5;\n", "p.csv:2: \"\" is not a number"},
  };
  for (const auto& [text, expected] : cases)
    EXPECT_THAT(csv_message(text), testing::StartsWith(expected)) << text;
}

/// Byte by byte, as UTK's documentation describes it.
std::string header(std::uint32_t type, std::uint32_t sets, std::uint32_t count, std::uint32_t dimensions) {
  std::string bytes = "UTK!";
  for (const std::uint32_t word : {type, sets, count, dimensions}) {
    for (int k = 0; k < 4; ++k) bytes += static_cast<char>(word >> (8 * k) & 255);
  }
  return bytes;
}

// 0.75, 0.5, 1 and 0.25 by IEEE 754.
const std::string kDoubles("\0\0\0\0\0\0\xe8\x3f\0\0\0\0\0\0\xe0\x3f\0\0\0\0\0\0\xf0\x3f\0\0\0\0\0\0\xd0\x3f",
                           32);
const std::string kFloats("\0\0\x40\x3f\0\0\0\x3f\0\0\x80\x3f\0\0\x80\x3e", 16);

TEST(ImportBinary, ReadsFloatsAndDoubles) {
  EXPECT_EQ(parse_binary_points(header(5, 1, 2, 2) + kDoubles, "p"),
            (std::vector<Points>{{{0.75, 0.5}, {0, 0.25}}}));
  EXPECT_EQ(parse_binary_points(header(4, 2, 1, 2) + kFloats, "p"),
            (std::vector<Points>{{{0.75, 0.5}}, {{0, 0.25}}}));
}

TEST(ImportBinary, SaysWhatIsWrong) {
  const std::string nan("\0\0\0\0\0\0\xf8\x7f\0\0\0\0\0\0\xe0\x3f", 16);
  const std::pair<std::string, const char*> cases[] = {
      {"", "p.bin: is too short"},
      {header(5, 1, 2, 2).substr(0, 19), "is too short"},
      {"PNG!" + header(5, 1, 2, 2).substr(4) + kDoubles, "does not begin with \"UTK!\""},
      {header(3, 1, 2, 2) + kDoubles, "type 3; only float"},
      {header(5, 1, 2, 3) + kDoubles, "3 dimensions; only two"},
      {header(5, 0, 2, 2), "holds no points"},
      {header(5, 1, 3, 2) + kDoubles, "has 32 bytes behind its header, not 1 sets of 3 points of 16"},
      {header(5, 1, 1, 2) + kDoubles, "has 32 bytes"},
      {header(5, 0xffffffff, 0xffffffff, 2) + kDoubles, "has 32 bytes"},
      {header(5, 1, 1, 2) + nan, "set 1, point 1: nan is not in [0, 1]"},
  };
  for (const auto& [bytes, expected] : cases)
    EXPECT_THAT(binary_message(bytes), testing::HasSubstr(expected));
}

TEST(Import, GoesByTheEnding) {
  const auto folder =
      std::filesystem::temp_directory_path() / ("capcon_import_" + std::to_string(::getpid()));
  std::filesystem::create_directory(folder);
  write_file(folder / "a.CSV", "0.5,0.25\n");
  write_file(folder / "a.bin", header(5, 1, 2, 2) + kDoubles);
  write_file(folder / "a.dat", "0.5 0.25\n#\n0 0\n");
  EXPECT_EQ(import_points(folder / "a.CSV").size(), 1u);
  EXPECT_EQ(import_points(folder / "a.bin")[0].size(), 2u);
  EXPECT_EQ(import_points(folder / "a.dat").size(), 2u);
  EXPECT_THROW(import_points(folder / "none.csv"), InputError);
  std::filesystem::remove_all(folder);
}

/// As NumPy 1.24 writes it: the header is padded to 64 bytes.
std::string npy(const std::string& type, const std::string& shape, const std::string& data,
                const std::string& order = "False") {
  std::string header = "{'descr': '" + type + "', 'fortran_order': " + order + ", 'shape': " + shape + ", }";
  header.resize((10 + header.size() + 1 + 63) / 64 * 64 - 10 - 1, ' ');
  header += '\n';
  return std::string("\x93NUMPY\x01\0", 8) + static_cast<char>(header.size() & 255) +
         static_cast<char>(header.size() >> 8) + header + data;
}

template <class Number>
std::string bytes_of(std::initializer_list<Number> numbers) {
  return {reinterpret_cast<const char*>(numbers.begin()), numbers.size() * sizeof(Number)};
}

TEST(ImportNpy, ReadsOneSetOrSeveral) {
  const std::string four = bytes_of<double>({0.25, 0.5, 1, 0.75, 0.125, 0, 0.5, 0.5});
  const Points points{{0.25, 0.5}, {0, 0.75}, {0.125, 0}, {0.5, 0.5}};
  EXPECT_EQ(parse_npy_points(npy("<f8", "(4, 2)", four), "p.npy"), std::vector<Points>{points});
  EXPECT_EQ(parse_npy_points(npy("<f8", "(2, 2, 2)", four), "p.npy"),
            (std::vector<Points>{{points[0], points[1]}, {points[2], points[3]}}));
  EXPECT_EQ(parse_npy_points(npy("<f4", "(1, 2)", bytes_of<float>({0.5f, 0.25f})), "p.npy"),
            (std::vector<Points>{{{0.5, 0.25}}}));
}

TEST(ImportNpy, SaysWhatIsWrong) {
  const std::string two = bytes_of<double>({0, 0.5});
  const auto message = [](const std::string& bytes) -> std::string {
    try {
      parse_npy_points(bytes, "p.npy");
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(message("0 0\n"), testing::HasSubstr("is no array of NumPy's"));
  EXPECT_THAT(message(npy("<i8", "(1, 2)", two)), testing::HasSubstr("must hold float32 or float64"));
  EXPECT_THAT(message(npy("<f8", "(2,)", two)), testing::HasSubstr("must be of shape"));
  EXPECT_THAT(message(npy("<f8", "(2, 1)", two)), testing::HasSubstr("must be of shape"));
  EXPECT_THAT(message(npy("<f8", "(1, 2)", two, "True")), testing::HasSubstr("Fortran's order"));
  EXPECT_THAT(message(npy("<f8", "(3, 2)", two)), testing::HasSubstr("has 16 bytes behind its header"));
  EXPECT_THAT(message(npy("<f8", "(0, 2)", "")), testing::HasSubstr("holds no points"));
  EXPECT_THAT(message(npy("<f8", "(1, 2)", bytes_of<double>({0, 1.5}))),
              testing::HasSubstr("set 1, point 1: 1.5 is not in [0, 1]"));
}

}  // namespace
}  // namespace capcon
