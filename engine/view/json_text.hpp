// Private to view/: JSON, written sequentially.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace trilith::view {

/// This class adds commas and quotes; the caller must match keys and ends (asserted).
class JsonText {
 public:
  JsonText& begin_object() { return begin('{'); }
  JsonText& begin_list() { return begin('['); }
  JsonText& end();  ///< closes the innermost object or list
  JsonText& key(std::string_view name);
  JsonText& text(std::string_view value);
  JsonText& number(double value);  ///< null if not finite
  JsonText& flag(bool value);

  JsonText& text(std::string_view name, std::string_view value) { return key(name).text(value); }
  JsonText& number(std::string_view name, double value) { return key(name).number(value); }
  JsonText& flag(std::string_view name, bool value) { return key(name).flag(value); }

  /// Returns the text; all objects and lists must have ended.
  std::string take();

 private:
  JsonText& begin(char bracket);
  void separate();
  void quote(std::string_view value);
  std::string out_;
  std::vector<char> open_;
  bool first_ = true, after_key_ = false;
};

}  // namespace trilith::view
