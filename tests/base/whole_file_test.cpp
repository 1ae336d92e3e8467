// Reads a complete file: non-files are rejected, and no read is endless.
#include "base/whole_file.hpp"

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <fstream>

#include "base/error.hpp"
#include "results/sample_run.hpp"

using namespace trilith;
using testing::Folder;

TEST_CASE("a text file is read unchanged, for any bytes") {
  const Folder folder;
  std::string bytes(200000, 'x');
  bytes[7] = '\0', bytes[9] = '\r', bytes.back() = '\n';
  for (const std::string& text : {std::string(), std::string("a"), bytes}) {
    std::ofstream(folder / "text", std::ios::binary) << text;
    CHECK(text_of_file(folder / "text", "script", 1 << 20) == text);
  }
}

TEST_CASE("a folder, a device, a file too large and a missing file are rejected as texts") {
  const Folder folder;
  const auto why = [](const std::filesystem::path& path) -> std::string {
    try {
      text_of_file(path, "script", 1000);
    } catch (const InputError& e) {
      return e.what();
    }
    return "";
  };
  std::ofstream(folder / "large") << std::string(1001, 'x');
  CHECK(why(folder / "large").ends_with("it holds more than 1000 bytes"));
  CHECK(why(folder.path).ends_with("it is a folder"));
  CHECK(why(folder / "none").ends_with("No such file or directory"));
  for (const char* device : {"/dev/full", "/dev/zero", "/dev/null"})
    CHECK(why(device) == fmt::format("cannot read script '{}': it is a device; give a file", device));
}
