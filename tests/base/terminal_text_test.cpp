#include "base/terminal_text.hpp"

#include <doctest/doctest.h>

#include "base/error.hpp"

using namespace trilith;

TEST_CASE("control characters are written as numbers, and all others are unchanged") {
  CHECK(terminal_text("\033]0;title\a") == "\\27]0;title\\7");
  CHECK(terminal_text(std::string_view("a\0b", 3)) == "a\\0b");
  CHECK(terminal_text("\x7F\r\b") == "\\127\\13\\8");
  CHECK(terminal_text("one\n\ttwo") == "one\n\ttwo");
  CHECK(one_line("one\n\ttwo") == "one\\10\\9two");
  CHECK(terminal_text("") == "");
}

TEST_CASE("control characters of eight bits are replaced, and other letters of UTF-8 are not") {
  CHECK(terminal_text("\xC2\x9B"
                      "31m") == "\\194\\15531m");
  CHECK(terminal_text("\xC2\x80\xC2\x9F") == "\\194\\128\\194\\159");
  for (const char* plain : {"Gewölbe", "\xC2\xA0", "\xC3\x9B", "桥", "θ ≤ 3°", " ~"}) {
    CHECK(terminal_text(plain) == plain);
    CHECK(find_control(plain) == std::string_view::npos);
  }
}

TEST_CASE("a name with a control character is rejected in one line that shows it") {
  CHECK_NOTHROW(require_printable("S3.left ü", "body"));
  CHECK_THROWS_WITH_AS(require_printable("red\033[31m", "body"),
                       "body 'red\\27[31m' holds the control character \\27; leave it out", InputError);
  CHECK_THROWS_WITH_AS(require_printable("two\nlines", "body"),
                       "body 'two\\10lines' holds the control character \\10; leave it out", InputError);
}
