#include "points/formula.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>

#include "base/error.h"

namespace capcon {

/// Recursive descent, one function a level of the grammar.
class FormulaParser {
 public:
  FormulaParser(std::string_view text, Formula& into) : text_(text), into_(into) {}

  void parse() {
    sum();
    if (peek() != '\0') fail(fmt::format("expected an operator, not \"{}\"", rest()));
  }

 private:
  using Op = Formula::Op;
  struct Name {
    std::string_view name;
    Op op;
    int arguments;
    double number;
  };
  static constexpr Name kNames[] = {
      {"x", Op::kX, 0, 0},       {"y", Op::kY, 0, 0},     {"pi", Op::kNumber, 0, std::numbers::pi},
      {"sin", Op::kSin, 1, 0},   {"cos", Op::kCos, 1, 0}, {"e", Op::kNumber, 0, std::numbers::e},
      {"exp", Op::kExp, 1, 0},   {"log", Op::kLog, 1, 0}, {"sqrt", Op::kSqrt, 1, 0},
      {"abs", Op::kAbs, 1, 0},   {"min", Op::kMin, 2, 0}, {"max", Op::kMax, 2, 0},
      {"pow", Op::kPower, 2, 0},
  };

  [[noreturn]] void fail(const std::string& message) const {
    throw InputError(fmt::format("the formula \"{}\", column {}: {}", text_.substr(0, 80), at_ + 1, message));
  }
  char peek() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  std::string rest() const { return std::string(text_.substr(at_, 12)); }
  void expect(char c) {
    if (peek() != c)
      fail(at_ < text_.size() ? fmt::format("expected '{}', not \"{}\"", c, rest())
                              : fmt::format("'{}' is missing", c));
    ++at_;
  }
  void emit(Op op, std::size_t operands, double number = 0) {
    into_.steps_.push_back({op, number});
    stack_ = stack_ + 1 - operands;
    into_.depth_ = std::max(into_.depth_, stack_);
  }

  void sum() {
    if (++nesting_ > 200) fail("more than 200 levels deep");
    product();
    for (char c = peek(); c == '+' || c == '-'; c = peek()) {
      ++at_;
      product();
      emit(c == '+' ? Op::kAdd : Op::kSubtract, 2);
    }
    --nesting_;
  }
  void product() {
    signed_power();
    for (char c = peek(); c == '*' || c == '/'; c = peek()) {
      ++at_;
      signed_power();
      emit(c == '*' ? Op::kMultiply : Op::kDivide, 2);
    }
  }
  void signed_power() {
    bool negative = false;
    for (char c = peek(); c == '-' || c == '+'; c = peek()) {
      negative ^= c == '-';
      ++at_;
    }
    power();
    if (negative) emit(Op::kNegate, 1);
  }
  void power() {
    if (++nesting_ > 200) fail("more than 200 levels deep");
    value();
    if (peek() == '^') {
      ++at_;
      signed_power();
      emit(Op::kPower, 2);
    }
    --nesting_;
  }
  void value() {
    const char c = peek();
    if (c == '(') {
      ++at_;
      sum();
      expect(')');
    } else if (std::isdigit(static_cast<unsigned char>(c)) || c == '.') {
      number();
    } else if (std::isalpha(static_cast<unsigned char>(c))) {
      name();
    } else {
      fail(at_ < text_.size() ? fmt::format("expected a value, not \"{}\"", rest()) : "a value is missing");
    }
  }
  void number() {
    double value = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc()) fail(fmt::format("\"{}\" is not a number", rest()));
    at_ = static_cast<std::size_t>(end - text_.data());
    emit(Op::kNumber, 0, value);
  }
  void name() {
    std::size_t end = at_;
    while (end < text_.size() && std::isalnum(static_cast<unsigned char>(text_[end]))) ++end;
    const std::string_view word = text_.substr(at_, end - at_);
    const auto* known =
        std::find_if(std::begin(kNames), std::end(kNames), [&](const Name& n) { return n.name == word; });
    if (known == std::end(kNames)) {
      fail(fmt::format("no name \"{}\"; there are x y pi e sin cos exp log sqrt abs min max pow", word));
    }
    at_ = end;
    for (int k = 0; k < known->arguments; ++k) {
      expect(k == 0 ? '(' : ',');
      sum();
    }
    if (known->arguments > 0) expect(')');
    emit(known->op, static_cast<std::size_t>(known->arguments), known->number);
  }

  std::string_view text_;
  Formula& into_;
  std::size_t at_ = 0, stack_ = 0;
  int nesting_ = 0;
};

Formula::Formula(std::string_view text) {
  FormulaParser(text, *this).parse();
}

double Formula::operator()(double x, double y) const {
  constexpr std::size_t kUsual = 32;
  double usual[kUsual];
  std::vector<double> large;
  if (depth_ > kUsual) large.resize(depth_);
  double* const stack = depth_ > kUsual ? large.data() : usual;
  double* top = stack - 1;
  for (const Step& step : steps_) {
    const auto binary = [&](auto f) {
      --top;
      *top = f(top[0], top[1]);
    };
    switch (step.op) {
      case Op::kNumber:
        *++top = step.number;
        break;
      case Op::kX:
        *++top = x;
        break;
      case Op::kY:
        *++top = y;
        break;
      case Op::kAdd:
        binary([](double a, double b) { return a + b; });
        break;
      case Op::kSubtract:
        binary([](double a, double b) { return a - b; });
        break;
      case Op::kMultiply:
        binary([](double a, double b) { return a * b; });
        break;
      case Op::kDivide:
        binary([](double a, double b) { return a / b; });
        break;
      case Op::kPower:
        binary([](double a, double b) { return std::pow(a, b); });
        break;
      case Op::kMin:
        binary([](double a, double b) { return a < b || std::isnan(a) ? a : b; });
        break;
      case Op::kMax:
        binary([](double a, double b) { return a > b || std::isnan(a) ? a : b; });
        break;
      case Op::kNegate:
        *top = -*top;
        break;
      case Op::kSin:
        *top = std::sin(*top);
        break;
      case Op::kCos:
        *top = std::cos(*top);
        break;
      case Op::kExp:
        *top = std::exp(*top);
        break;
      case Op::kLog:
        *top = std::log(*top);
        break;
      case Op::kSqrt:
        *top = std::sqrt(*top);
        break;
      case Op::kAbs:
        *top = std::abs(*top);
        break;
    }
  }
  return *top;
}

}  // namespace capcon
