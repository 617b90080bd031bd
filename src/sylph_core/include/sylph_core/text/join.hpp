#pragma once

#include <string>

namespace sylph {

/// Texts in a row, for messages: "cf1, alpha, mule_27"; nothing where there is none.
/// @param toText  of an element
template <typename Elements, typename ToText>
std::string join(const Elements& elements, const std::string& between, ToText toText) {
  std::string text;
  bool is_first = true;
  for (const auto& element : elements) {
    text += is_first ? "" : between;
    text += toText(element);
    is_first = false;
  }
  return text;
}

/// Of elements that are texts.
template <typename Texts>
std::string join(const Texts& texts, const std::string& between = ", ") {
  return join(texts, between, [](const std::string& text) { return text; });
}

}  // namespace sylph
