// Lines, words and numbers of a text file, with messages that name file and line.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trilith {

/// `text` without blanks (space, tab, carriage return) at both ends.
std::string_view trimmed(std::string_view text);

/// `text` without the bytes (Ctrl-Z, zeros) that some programs append to a text file.
std::string_view without_padding(std::string_view text);

/// The words of `text`, split at blanks and at any of `separators`.
std::vector<std::string_view> words_of(std::string_view text, std::string_view separators = "");

/// `text` in lower case (ASCII only).
std::string lower_case(std::string_view text);

/// The finite number that `text` contains as a whole (`-.25E-2`, "+3"), or none.
std::optional<double> number_in(std::string_view text);

/// Reads a text line by line, with 1 as the first line.
class TextLines {
 public:
  /// Both are kept by reference or copied: `text` must live as long as this; `name` is the file's.
  TextLines(std::string_view text, std::string name) : rest_(text), name_(std::move(name)) {}

  /// The next line without its end, or none. Lines end with LF or CR LF.
  std::optional<std::string_view> next();

  /// Number of the line last given, 0 before the first.
  int number() const { return number_; }

  /// Throws InputError "motion file 'NAME' line N: message".
  [[noreturn]] void fail(const std::string& message) const;
  /// Throws InputError "motion file 'NAME': message" for an error of the whole file.
  [[noreturn]] void fail_whole(const std::string& message) const;

  /// The number in `text`; fails for any other text. `what` names it in the message.
  double require_number(std::string_view text, std::string_view what) const;
  /// The count (1 or above) in `text`; fails for any other text.
  std::size_t require_count(std::string_view text, std::string_view what) const;

 private:
  std::string_view rest_;
  std::string name_;
  int number_ = 0;
};

/// `text` shortened to 40 characters and freed of control characters, for a message.
std::string shown(std::string_view text);

}  // namespace trilith
