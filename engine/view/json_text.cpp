#include "view/json_text.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

namespace trilith::view {

void JsonText::separate() {
  if (!first_ && !after_key_) out_ += ',';
  first_ = after_key_ = false;
}

void JsonText::quote(std::string_view value) {
  out_ += '"';
  for (const char c : value) {
    if (c == '"' || c == '\\') out_ += '\\';
    if (static_cast<unsigned char>(c) < 32)
      out_ += fmt::format("\\u{:04x}", static_cast<int>(c));
    else
      out_ += c;
  }
  out_ += '"';
}

JsonText& JsonText::begin(char bracket) {
  separate();
  out_ += bracket;
  open_.push_back(bracket);
  first_ = true;
  return *this;
}

JsonText& JsonText::end() {
  assert(!open_.empty());
  out_ += open_.back() == '{' ? '}' : ']';
  open_.pop_back();
  first_ = false;
  return *this;
}

JsonText& JsonText::key(std::string_view name) {
  assert(!open_.empty() && open_.back() == '{');
  separate();
  quote(name);
  out_ += ':';
  after_key_ = true;
  return *this;
}

JsonText& JsonText::text(std::string_view value) {
  separate();
  quote(value);
  return *this;
}

JsonText& JsonText::number(double value) {
  separate();
  out_ += std::isfinite(value) ? fmt::format("{}", value) : "null";
  return *this;
}

JsonText& JsonText::flag(bool value) {
  separate();
  out_ += value ? "true" : "false";
  return *this;
}

std::string JsonText::take() {
  assert(open_.empty());
  return std::move(out_);
}

}  // namespace trilith::view
