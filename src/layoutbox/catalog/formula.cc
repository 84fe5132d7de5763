// Formulas of the catalogue: linear in w, d, h with numbers, + - * / and parentheses.
#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "layoutbox/catalog/catalog.h"

namespace layoutbox {
namespace {

constexpr int kDeepest = 30;

// Recursive descent; values are in metres, so a plain number is a LinearFormula with only a constant.
class FormulaParser {
 public:
  FormulaParser(std::string_view text, double index) : text_(text), index_(index) {}

  Result<LinearFormula> parse() {
    LAYOUTBOX_ASSIGN(LinearFormula value, sum(0));
    skip_spaces();
    if (place_ != text_.size()) return wrong(fmt::format("'{}' was not expected", text_[place_]));
    value.constant *= 1000;
    return value;
  }

 private:
  Result<LinearFormula> sum(int depth) {
    LAYOUTBOX_ASSIGN(LinearFormula value, product(depth));
    for (;;) {
      const char sign = take("+-");
      if (sign == 0) return value;
      LAYOUTBOX_ASSIGN(const LinearFormula term, product(depth));
      value = plus(value, term, sign == '+' ? 1 : -1);
    }
  }

  Result<LinearFormula> product(int depth) {
    LAYOUTBOX_ASSIGN(LinearFormula value, factor(depth));
    for (;;) {
      const char sign = take("*/");
      if (sign == 0) return value;
      LAYOUTBOX_ASSIGN(const LinearFormula other, factor(depth));
      if (sign == '/') {
        if (!is_number(other)) return wrong("only a number can divide");
        if (std::abs(other.constant) < 1e-12) return wrong("division by zero");
        value = times(value, 1 / other.constant);
      } else if (is_number(other)) {
        value = times(value, other.constant);
      } else if (is_number(value)) {
        value = times(other, value.constant);
      } else {
        return wrong("sizes cannot be multiplied with each other");
      }
    }
  }

  Result<LinearFormula> factor(int depth) {
    if (depth > kDeepest) return wrong("too many parentheses");
    if (take("-") != 0) {
      LAYOUTBOX_ASSIGN(const LinearFormula value, factor(depth + 1));
      return times(value, -1);
    }
    if (take("(") != 0) {
      LAYOUTBOX_ASSIGN(const LinearFormula value, sum(depth + 1));
      if (take(")") == 0) return wrong("a ) is missing");
      return value;
    }
    switch (take("wdhi")) {
      case 'w': return LinearFormula{1, 0, 0, 0};
      case 'd': return LinearFormula{0, 1, 0, 0};
      case 'h': return LinearFormula{0, 0, 1, 0};
      case 'i': return LinearFormula{0, 0, 0, index_};
      default: break;
    }
    double number = 0;
    const auto [end, error] = std::from_chars(text_.data() + place_, text_.data() + text_.size(), number, std::chars_format::fixed);
    if (error != std::errc{}) return wrong("a number, w, d, h, i or ( was expected");
    place_ = static_cast<std::size_t>(end - text_.data());
    return LinearFormula{0, 0, 0, number};
  }

  void skip_spaces() {
    while (place_ < text_.size() && text_[place_] == ' ') ++place_;
  }

  // The next character if it is one of `wanted`, else 0.
  char take(std::string_view wanted) {
    skip_spaces();
    if (place_ == text_.size() || wanted.find(text_[place_]) == std::string_view::npos) return 0;
    return text_[place_++];
  }

  static bool is_number(const LinearFormula& f) { return f.w == 0 && f.d == 0 && f.h == 0; }
  static LinearFormula times(const LinearFormula& f, double k) { return {f.w * k, f.d * k, f.h * k, f.constant * k}; }
  static LinearFormula plus(const LinearFormula& a, const LinearFormula& b, double sign) {
    return {a.w + sign * b.w, a.d + sign * b.d, a.h + sign * b.h, a.constant + sign * b.constant};
  }

  Failure wrong(std::string_view what) const {
    return fail(ErrorCode::kParse, fmt::format("in the formula \"{}\" at character {}: {}", text_, place_ + 1, what), {},
                "write a linear form such as \"w/2 - 0.02\"");
  }

  std::string_view text_;
  double index_;
  std::size_t place_ = 0;
};

}  // namespace

Result<LinearFormula> parse_formula(std::string_view text, double index) { return FormulaParser(text, index).parse(); }

}  // namespace layoutbox
