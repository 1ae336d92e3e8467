#include "results/file/open_written.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <string>

namespace trilith::results {
namespace {

constexpr unsigned open_seconds = 20;  // a file that takes longer to open is treated as hanging

h5::Handle open_here(const std::filesystem::path& path) {
  const hid_t plain = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  if (plain >= 0) return h5::Handle(plain, H5Fclose, "");
  const std::string why = h5::reason();
  // The pause between attempts doubles from 1 ns: 25 attempts take 30 ms, HDF5's default of 100 would not end.
  const h5::Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose, "cannot make a property list");
  h5::check(H5Pset_metadata_read_attempts(access.get(), 25), "cannot set the number of attempts");
  const hid_t beside = H5Fopen(path.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access.get());
  if (beside >= 0) return h5::Handle(beside, H5Fclose, "");
  throw h5::Failure(fmt::format("cannot be opened: {}; it may be cut or damaged", why));
}

/// Opens and closes the file in a separate process: on some damaged files HDF5 1.10 ends the process, or hangs at its
/// end. Returns the reason for which it cannot be opened, or "".
std::string open_elsewhere(const std::filesystem::path& path) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0) return "";  // as if tested: it is opened in this process next
  const pid_t child = ::fork();
  if (child == 0) {
    ::signal(SIGALRM, SIG_DFL);
    ::alarm(open_seconds);
    std::string why;
    try {
      open_here(path);
    } catch (const std::exception& failure) {
      why = failure.what();
    }
    const bool told = ::write(ends[1], why.data(), why.size()) == static_cast<ssize_t>(why.size());
    ::_exit(told ? 0 : 1);
  }
  ::close(ends[1]);
  std::string why;
  std::array<char, 1024> block;
  for (ssize_t got = 0; child > 0 && (got = ::read(ends[0], block.data(), block.size())) != 0;) {
    if (got < 0 && errno != EINTR) break;
    if (got > 0) why.append(block.data(), static_cast<std::size_t>(got));
  }
  ::close(ends[0]);
  int status = 0;
  while (child > 0 && ::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (child > 0 && why.empty() && WIFSIGNALED(status))
    why = "cannot be opened: it is damaged in a way that ends the HDF5 library";
  return why;
}

}  // namespace

h5::Handle open_written(const std::filesystem::path& path) {
  const std::string why = open_elsewhere(path);
  if (!why.empty()) throw h5::Failure(why);
  return open_here(path);
}

}  // namespace trilith::results
