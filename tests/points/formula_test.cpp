#include "points/formula.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "base/error.h"

namespace capcon {
namespace {

std::string message_of(const std::string& text) {
  try {
    Formula formula(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Formula, Computes) {
  const double x = 0.3, y = 0.7;
  const std::pair<const char*, double> cases[] = {
      {"1", 1},
      {" .5e1 ", 5},
      {"x", x},
      {"1 - 2 - 3", -4},
      {"1-2*3+4", -1},
      {"8/4/2", 1},
      {"2^3^2", 512},
      {"-2^2", -4},
      {"2^-1", 0.5},
      {"--x", x},
      {"-+-+2", 2},
      {"2*-3", -6},
      {"(1+2)*3", 9},
      {"((((y))))", y},
      {"sin(pi*x)+cos(y)", std::sin(M_PI * x) + std::cos(y)},
      {"exp(-20*((x-0.5)^2+(y-0.5)^2))", std::exp(-20 * (0.04 + 0.04))},
      {"log(e)", 1},
      {"sqrt(abs(x-y))", std::sqrt(0.4)},
      {"min(x,y)+10*max(x, y)", 7.3},
      {"pow(x,2)-x^2", 0},
      {"max(0,min(1,x*100))", 1},
      {"1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+(1+"
       "(1"
       "))))))))))))))))))))))))))))))))))",
       35},
  };
  for (const auto& [text, expected] : cases) EXPECT_NEAR(Formula(text)(x, y), expected, 1e-14) << text;
  EXPECT_TRUE(std::isnan(Formula("sqrt(x-1)")(x, y)));
  EXPECT_TRUE(std::isnan(Formula("max(0, sqrt(x-1))")(x, y)));
  EXPECT_TRUE(std::isnan(Formula("max(sqrt(x-1), 0)")(x, y)));
}

TEST(Formula, SaysWhereItStopsMakingSense) {
  const std::pair<std::string, const char*> cases[] = {
      {"", "column 1: a value is missing"},
      {"   ", "column 4: a value is missing"},
      {"x +", "column 4: a value is missing"},
      {"x y", "column 3: expected an operator, not \"y\""},
      {"2x", "column 2: expected an operator, not \"x\""},
      {"(x", "column 3: ')' is missing"},
      {"x)", "column 2: expected an operator, not \")\""},
      {"sin x", "column 5: expected '(', not \"x\""},
      {"min(x)", "column 6: expected ',', not \")\""},
      {"max(x,y,1)", "column 8: expected ')', not \",1)\""},
      {"1+z*2", "column 3: no name \"z\"; there are x y pi e"},
      {"x*/y", "column 3: expected a value, not \"/y\""},
      {"1e999", "column 1: \"1e999\" is not a number"},
      {".", "column 1: \".\" is not a number"},
      {"x;y", "column 2: expected an operator"},
      {std::string(100000, '('), "more than 200 levels deep"},
      {[] {
         std::string towers;
         for (int k = 0; k < 100000; ++k) towers += "2^";
         return towers;
       }(),
       "more than 200 levels deep"},
  };
  for (const auto& [text, expected] : cases) EXPECT_THAT(message_of(text), testing::HasSubstr(expected));
  EXPECT_NEAR(Formula(std::string(100000, '-') + "x")(0.5, 0), 0.5, 0);
}

}  // namespace
}  // namespace capcon
