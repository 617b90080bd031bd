#pragma once

#include <charconv>
#include <stdexcept>
#include <string>
#include <string_view>

#include "sylph_core/grid/cell.hpp"

namespace sylph {

/// What a plan file may hold.
constexpr std::size_t kMaxPlanBytes = std::size_t{1} << 30;

/// Takes numbers and marks from the front of a line of a plan file.
class PlanScanner {
 public:
  /// @param line  outlives the scanner
  explicit PlanScanner(const std::string& line) : next_(line.data()), end_(next_ + line.size()) {}

  /// Passes over blanks.
  bool isAtEnd() {
    while (next_ != end_ && (*next_ == ' ' || *next_ == '\t')) {
      ++next_;
    }
    return next_ == end_;
  }

  /// @throws std::invalid_argument if something else stands there
  int number() {
    int value = 0;
    const auto [rest, error] = std::from_chars(next_, end_, value);
    if (error != std::errc()) {
      throw std::invalid_argument("a whole number");
    }
    next_ = rest;
    return value;
  }

  /// @throws std::invalid_argument if something else stands there
  void mark(std::string_view text) {
    if (std::string_view(next_, static_cast<std::size_t>(end_ - next_)).substr(0, text.size()) !=
        text) {
      throw std::invalid_argument("'" + std::string(text) + "'");
    }
    next_ += text.size();
  }

  /// "(row,col)".
  /// @throws std::invalid_argument if something else stands there
  Cell cell() {
    mark("(");
    const int row = number();
    mark(",");
    const int col = number();
    mark(")");
    return {row, col};
  }

  std::string rest() const { return {next_, end_}; }

 private:
  const char* next_;
  const char* end_;
};

}  // namespace sylph
