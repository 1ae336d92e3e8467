// A program outside the project, against the installed engine: it asks the engine what a misspelt word should have
// been.
#include <fmt/format.h>

#include <trilith/base/error.hpp>
#include <trilith/base/nearest.hpp>

int main() {
  try {
    trilith::require_positive(-2.0, "body 'pier 3': mass", "kg");
  } catch (const trilith::InputError& error) {
    fmt::print("{}\n", error.what());
    fmt::print("heigth{}\n", trilith::name_hint("heigth", {"width", "height"}));
    return 0;
  }
  fmt::print("a negative mass was accepted\n");
  return 1;
}
