#include "results/file/file_driver.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <map>
#include <memory>

namespace trilith::results::h5 {
namespace {

constexpr haddr_t page_size = 4096;
using Page = std::array<unsigned char, page_size>;

/// One open file. HDF5 uses the base class only.
struct Device : H5FD_t {
  int descriptor = -1;
  dev_t device = 0;
  ino_t inode = 0;
  haddr_t end_of_addresses = 0;
  haddr_t end_of_file = 0;
  FileStatus* status = nullptr;
  std::map<haddr_t, Page> kept;  // written after the failure, by page
};

Device& of(H5FD_t* file) {
  return *static_cast<Device*>(file);
}
const Device& of(const H5FD_t* file) {
  return *static_cast<const Device*>(file);
}

struct Info {
  FileStatus* status;
  int descriptor;
};

// Reads the file; zeros beyond its end. Returns 0 or errno.
int read_file(const Device& file, haddr_t at, std::size_t size, unsigned char* out) {
  while (size > 0) {
    const ssize_t count = ::pread(file.descriptor, out, size, static_cast<off_t>(at));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    if (count == 0) {
      std::memset(out, 0, size);
      return 0;
    }
    at += static_cast<haddr_t>(count);
    size -= static_cast<std::size_t>(count);
    out += count;
  }
  return 0;
}

// Returns 0 or errno. Beyond the limit on file size the system would send a signal that kills the process, so the limit
// is checked first.
int write_file(const Device& file, haddr_t at, std::size_t size, const unsigned char* data) {
  struct rlimit limit {};
  if (::getrlimit(RLIMIT_FSIZE, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY && at + size > limit.rlim_cur)
    return EFBIG;
  while (size > 0) {
    const ssize_t count = ::pwrite(file.descriptor, data, size, static_cast<off_t>(at));
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) return errno;
    if (count == 0) return ENOSPC;
    at += static_cast<haddr_t>(count);
    size -= static_cast<std::size_t>(count);
    data += count;
  }
  return 0;
}

// Calls `use(page, first byte in page, number of bytes)` for every page in [at, at + size).
template <class Use>
void for_pages(haddr_t at, std::size_t size, Use use) {
  while (size > 0) {
    const haddr_t page = at / page_size * page_size, from = at - page;
    const std::size_t count = std::min<std::size_t>(size, static_cast<std::size_t>(page_size - from));
    use(page, from, count);
    at += count;
    size -= count;
  }
}

void keep(Device& file, haddr_t at, std::size_t size, const unsigned char* data) {
  for_pages(at, size, [&](haddr_t page, haddr_t from, std::size_t count) {
    const auto [entry, is_new] = file.kept.try_emplace(page);
    if (is_new) read_file(file, page, page_size, entry->second.data());
    std::memcpy(entry->second.data() + from, data, count);
    data += count;
  });
}

// HDF5 opens a new file twice: once to check whether it is open already, and then to truncate it.
H5FD_t* open_device(const char*, unsigned flags, hid_t access, haddr_t) {
  const auto* info = static_cast<const Info*>(H5Pget_driver_info(access));
  if (info == nullptr) return nullptr;
  const int descriptor = ::fcntl(info->descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  struct stat about {};
  if (descriptor < 0 || ((flags & H5F_ACC_TRUNC) && ::ftruncate(descriptor, 0) != 0) ||
      ::fstat(descriptor, &about) != 0) {
    info->status->error = errno;
    if (descriptor >= 0) ::close(descriptor);
    return nullptr;
  }
  auto file = std::make_unique<Device>();
  file->descriptor = descriptor;
  file->device = about.st_dev;
  file->inode = about.st_ino;
  file->end_of_file = static_cast<haddr_t>(about.st_size);
  file->status = info->status;
  return file.release();
}

herr_t close_device(H5FD_t* file) {
  ::close(of(file).descriptor);
  delete &of(file);
  return 0;
}

int compare_devices(const H5FD_t* a, const H5FD_t* b) {
  if (of(a).device != of(b).device) return of(a).device < of(b).device ? -1 : 1;
  if (of(a).inode != of(b).inode) return of(a).inode < of(b).inode ? -1 : 1;
  return 0;
}

// No accumulator and no sieve: rows and metadata reach the file in the order in which HDF5 writes them.
herr_t query(const H5FD_t*, unsigned long* flags) {
  *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_SUPPORTS_SWMR_IO |
           H5FD_FEAT_DEFAULT_VFD_COMPATIBLE;
  return 0;
}

haddr_t end_of_addresses(const H5FD_t* file, H5FD_mem_t) {
  return of(file).end_of_addresses;
}
haddr_t end_of_file(const H5FD_t* file, H5FD_mem_t) {
  return of(file).end_of_file;
}

herr_t set_end_of_addresses(H5FD_t* file, H5FD_mem_t, haddr_t address) {
  of(file).end_of_addresses = address;
  return 0;
}

herr_t read_device(H5FD_t* base, H5FD_mem_t, hid_t, haddr_t at, std::size_t size, void* buffer) {
  const Device& file = of(base);
  auto* out = static_cast<unsigned char*>(buffer);
  if (read_file(file, at, size, out) != 0) return -1;
  if (file.kept.empty()) return 0;
  for_pages(at, size, [&](haddr_t page, haddr_t from, std::size_t count) {
    const auto entry = file.kept.find(page);
    if (entry != file.kept.end()) std::memcpy(out, entry->second.data() + from, count);
    out += count;
  });
  return 0;
}

herr_t write_device(H5FD_t* base, H5FD_mem_t, hid_t, haddr_t at, std::size_t size, const void* buffer) {
  Device& file = of(base);
  const auto* data = static_cast<const unsigned char*>(buffer);
  FileStatus& status = *file.status;
  if (status.error == 0) status.error = write_file(file, at, size, data);
  if (status.error != 0) keep(file, at, size, data);
  file.end_of_file = std::max(file.end_of_file, at + size);
  return 0;
}

herr_t truncate_device(H5FD_t* base, hid_t, hbool_t) {
  Device& file = of(base);
  if (file.end_of_addresses == file.end_of_file) return 0;
  FileStatus& status = *file.status;
  if (status.error == 0 && ::ftruncate(file.descriptor, static_cast<off_t>(file.end_of_addresses)) != 0)
    status.error = errno;
  file.end_of_file = file.end_of_addresses;
  return 0;
}

// The lock of PartFile excludes a second writer; readers need none.
herr_t lock_device(H5FD_t*, hbool_t) {
  return 0;
}
herr_t unlock_device(H5FD_t*) {
  return 0;
}

H5FD_class_t make_driver() {
  H5FD_class_t driver{};
#ifdef H5FD_CLASS_VERSION
  driver.version = H5FD_CLASS_VERSION;
  driver.value = static_cast<H5FD_class_value_t>(501);
#endif
  driver.name = "trilith";
  driver.maxaddr = (haddr_t{1} << 62) - 1;
  driver.fc_degree = H5F_CLOSE_WEAK;
  driver.fapl_size = sizeof(Info);
  driver.open = open_device;
  driver.close = close_device;
  driver.cmp = compare_devices;
  driver.query = query;
  driver.get_eoa = end_of_addresses;
  driver.set_eoa = set_end_of_addresses;
  driver.get_eof = end_of_file;
  driver.read = read_device;
  driver.write = write_device;
  driver.truncate = truncate_device;
  driver.lock = lock_device;
  driver.unlock = unlock_device;
  const H5FD_mem_t map[] = H5FD_FLMAP_DICHOTOMY;
  std::copy(std::begin(map), std::end(map), std::begin(driver.fl_map));
  return driver;
}

}  // namespace

void require_written(const FileStatus& status, std::string_view what) {
  if (status.error != 0) throw Failure(fmt::format("{}: {}", what, std::strerror(status.error)));
}

void use_driver(hid_t access, int descriptor, FileStatus& status) {
  static const H5FD_class_t driver = make_driver();
  // Registered permanently: a file with the last reference to its driver would close through freed memory.
  static const hid_t id = H5FDregister(&driver);
  check(id, "cannot register the file driver");
  const Info info{&status, descriptor};
  check(H5Pset_driver(access, id, &info), "cannot set the file driver");
}

}  // namespace trilith::results::h5
