// Private to results/: HDF5 identifiers that close automatically, and HDF5 errors as one exception.
#pragma once

#include <hdf5.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace trilith::results::h5 {

/// Failure of an HDF5 call. The message contains the attempted operation and the reason, without the file name; the
/// public functions convert it into a ResultsError with the file name.
class Failure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The deepest reason on HDF5's error stack, e.g. "No space left on device"; the stack is not cleared.
std::string reason();

/// Throws Failure "<what>: <reason>".
[[noreturn]] void fail(std::string_view what);

/// Throws Failure if `status` is negative; otherwise returns it.
template <class Status>
Status check(Status status, std::string_view what) {
  if (status < 0) fail(what);
  return status;
}

/// Owns one HDF5 identifier and closes it with the given function.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Handle() = default;
  /// Takes `id`; throws Failure if it is negative.
  Handle(hid_t id, Close closer, std::string_view what) : id_(check(id, what)), close_(closer) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle& operator=(Handle&& other) noexcept {
    std::swap(id_, other.id_);
    std::swap(close_, other.close_);
    return *this;
  }
  ~Handle() { reset(); }
  void reset() {
    if (id_ >= 0) close_(id_);
    id_ = H5I_INVALID_HID;
  }
  /// Closes; throws Failure if HDF5 fails.
  void close(std::string_view what) {
    if (id_ < 0) return;
    if (close_(std::exchange(id_, H5I_INVALID_HID)) < 0) fail(what);
  }
  /// Releases ownership of the identifier.
  hid_t release() { return std::exchange(id_, H5I_INVALID_HID); }
  hid_t get() const { return id_; }
  explicit operator bool() const { return id_ >= 0; }

 private:
  hid_t id_ = H5I_INVALID_HID;
  Close close_ = nullptr;
};

/// Throws Failure if `type`, or a column of it, is not used in results files: only usual numbers and texts of fixed
/// length are. HDF5 itself writes beyond its memory when it converts some damaged types.
void require_plain(hid_t type, std::string_view owner);

/// Suppresses HDF5's error output during its lifetime.
class Quiet {
 public:
  Quiet() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~Quiet() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// UTF-8 string type of `length` bytes, padded with zeros. Text of variable length is not used: HDF5 stores it without
/// a checksum and crashes if it is damaged.
Handle text_type(std::size_t length);

/// Simple data space of the given extents; without extents a scalar.
Handle space(const std::vector<hsize_t>& extents);

/// `text` as valid UTF-8 without zero bytes: invalid bytes become '?'.
std::string clean(std::string_view text);

/// The cleaned texts padded with zeros to `length`, which is set to the longest (at least 1), one after the other.
std::string pack_texts(const std::vector<std::string>& texts, std::size_t& length);

/// Text beyond 60,000 bytes is cut.
void write_attribute(hid_t object, const char* name, std::string_view text);
void write_attribute(hid_t object, const char* name, const std::vector<std::string>& texts);
void write_attribute(hid_t object, const char* name, int value);

bool has_attribute(hid_t object, const char* name);
/// Throws Failure if the attribute is missing or is not a text.
std::string read_text(hid_t object, const char* name);
/// All texts of an attribute of texts with equal length.
std::vector<std::string> read_texts(hid_t object, const char* name);
/// Throws Failure if the attribute is missing or is not an integer.
int read_int(hid_t object, const char* name);

/// Names of a group's members in order of creation.
std::vector<std::string> member_names(hid_t group);

/// The extents of a data set.
std::vector<hsize_t> extents(hid_t dataset);

}  // namespace trilith::results::h5
