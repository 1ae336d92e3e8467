#include "base/fresh_file.hpp"

#include <doctest/doctest.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <set>

#include "base/error.hpp"
#include "results/sample_run.hpp"

using namespace trilith;
using testing::bytes_of;
using testing::Folder;
namespace fs = std::filesystem;

namespace {

void write_text(const fs::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

std::size_t files_in(const Folder& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder.path), fs::directory_iterator()));
}

}  // namespace

TEST_CASE("a pipe or a device is not replaced by a file") {
  const Folder folder;
  const fs::path pipe = folder / "pipe";
  REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
  CHECK_THROWS_WITH_AS(FreshFile{pipe}, doctest::Contains("is not a regular file"), InputError);
  CHECK_THROWS_AS(FreshFile{"/dev/null"}, InputError);
  CHECK(fs::is_fifo(pipe));
  CHECK(files_in(folder) == 1);
}

TEST_CASE("a new file replaces its target when it is complete, and leaves nothing if it is abandoned") {
  const Folder folder;
  write_text(folder / "page", "old");
  {
    FreshFile given_up(folder / "page");
    given_up.write("half");
    CHECK(files_in(folder) == 2);
  }
  CHECK(files_in(folder) == 1);
  CHECK(bytes_of(folder / "page") == "old");
  FreshFile file(folder / "page");
  file.write("new");
  CHECK(bytes_of(folder / "page") == "old");
  file.take_place();
  CHECK(files_in(folder) == 1);
  CHECK(bytes_of(folder / "page") == "new");
}

TEST_CASE("new files have random names and the access rights of any new file") {
  const Folder folder;
  std::set<fs::path> names;
  for (int i = 0; i < 50; ++i) {
    const FreshFile file(folder / "page");
    CHECK(file.path().parent_path() == folder.path);
    names.insert(file.path());
  }
  CHECK(names.size() == 50);
  write_text(folder / "usual", "");
  FreshFile file(folder / "page");
  file.take_place();
  CHECK(fs::status(folder / "page").permissions() == fs::status(folder / "usual").permissions());
}

TEST_CASE("a new file keeps symbolic links at its name, whether or not their targets exist") {
  const Folder folder;
  fs::create_directory(folder / "far");
  for (const char* real : {"far/page", "far/none"}) {
    fs::remove(folder / "link");
    fs::remove(folder / "link2");
    fs::create_symlink(real, folder / "link");
    fs::create_symlink(folder / "link", folder / "link2");
    write_text(folder / "far/page", "old");
    FreshFile file(folder / "link2");
    CHECK(file.path().parent_path() == folder / "far");
    file.write("new");
    file.take_place();
    CHECK(fs::is_symlink(folder / "link"));
    CHECK(fs::is_symlink(folder / "link2"));
    CHECK(bytes_of(folder / real) == "new");
  }
}

TEST_CASE("a link that leads back to itself is an error, not an endless search") {
  const Folder folder;
  fs::create_symlink("loop", folder / "loop");
  CHECK(past_links(folder / "loop").filename() == "loop");
  CHECK_THROWS_AS(FreshFile(folder / "none" / "page"), std::system_error);
}

TEST_CASE("closed standard streams are not replaced by new files") {
  const Folder folder;
  const pid_t child = ::fork();
  if (child == 0) {
    for (const int standard : {0, 1, 2}) ::close(standard);
    const int lowest = ::open("/dev/null", O_RDWR | O_CLOEXEC);
    const int moved = above_standard(lowest);
    const FreshFile file(folder / "page");
    ::_exit(lowest == 0 && moved > 2 && file.descriptor() > 2 && ::fcntl(0, F_GETFD) < 0 ? 0 : 1);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
  CHECK(above_standard(-1) == -1);
}
