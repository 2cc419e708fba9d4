#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace capcon {

/// A formula in x and y: + - * / ^ (to the right, above unary minus), parentheses, sin cos exp log sqrt abs
/// of one value, min max pow of two, pi and e.
class Formula {
 public:
  /// InputError with the column (from 1) where the text stops making sense.
  explicit Formula(std::string_view text);
  double operator()(double x, double y) const;

 private:
  friend class FormulaParser;
  enum class Op : std::uint8_t {
    kNumber,
    kX,
    kY,
    kAdd,
    kSubtract,
    kMultiply,
    kDivide,
    kPower,
    kNegate,
    kSin,
    kCos,
    kExp,
    kLog,
    kSqrt,
    kAbs,
    kMin,
    kMax
  };
  struct Step {
    Op op;
    double number = 0;
  };
  std::vector<Step> steps_;  ///< operands before operators
  std::size_t depth_ = 0;    ///< of the stack
};

}  // namespace capcon
