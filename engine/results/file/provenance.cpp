#include "results/file/provenance.hpp"

#include <fmt/format.h>
#include <hdf5.h>
#include <sys/utsname.h>

#include <ctime>

namespace trilith::results {
namespace {

std::string compiler() {
#if defined(__clang__)
  return fmt::format("clang {}", __clang_version__);
#elif defined(__GNUC__)
  return fmt::format("g++ {}", __VERSION__);
#else
  return "unknown compiler";
#endif
}

std::string platform() {
  utsname name{};
  if (::uname(&name) != 0) return "unknown platform";
  return fmt::format("{} {} {}", name.sysname, name.release, name.machine);
}

std::string now() {
  const std::time_t seconds = std::time(nullptr);
  std::tm parts{};
  ::gmtime_r(&seconds, &parts);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", parts.tm_year + 1900, parts.tm_mon + 1, parts.tm_mday,
                     parts.tm_hour, parts.tm_min, parts.tm_sec);
}

}  // namespace

std::string hdf5_version() {
  unsigned major = 0, minor = 0, release = 0;
  return H5get_libversion(&major, &minor, &release) < 0 ? "unknown" : fmt::format("{}.{}.{}", major, minor, release);
}

Provenance provenance_here() {
  Provenance result;
  result.git_commit = built_from();
  result.compiler = compiler();
  result.platform = platform();
  result.start_time = now();
  return result;
}

}  // namespace trilith::results
