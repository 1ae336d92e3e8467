// Converts values to bytes and back, for restart files. Both directions use the same function of a type,
//
//   template <class File>
//   void each_field(File& file, Thing& thing) { file.item(thing.name), file.item(thing.values); }
//
// so that the written and the read format agree. Numbers have the byte order of the machine.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/error.hpp"

namespace trilith {

template <class T>
inline constexpr bool is_plain_value = std::is_arithmetic_v<T> || std::is_enum_v<T>;

class ByteWriter {
 public:
  template <class T>
  void item(const T& value) {
    if constexpr (is_plain_value<T>)
      bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);
    else
      each_field(*this, const_cast<T&>(value));  // does not change it
  }
  void item(const std::string& text) {
    item(static_cast<std::uint64_t>(text.size()));
    bytes_.append(text);
  }
  template <class T>
  void item(const std::vector<T>& values) {
    item(static_cast<std::uint64_t>(values.size()));
    if constexpr (is_plain_value<T>)
      bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    else
      for (const T& value : values) item(value);
  }
  template <class T>
  void item(const std::optional<T>& value) {
    item(value.has_value());
    if (value) item(*value);
  }
  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

class ByteReader {
 public:
  /// `owner` begins messages: "checkpoint 'run.h5.restart/at-1'". The bytes must outlive the reader.
  ByteReader(std::string_view bytes, std::string owner) : bytes_(bytes), owner_(std::move(owner)) {}

  template <class T>
  void item(T& value) {
    if constexpr (is_plain_value<T>)
      std::memcpy(&value, next(sizeof value).data(), sizeof value);
    else
      each_field(*this, value);
  }
  void item(bool& value) {
    std::uint8_t byte = 0;
    item(byte);
    if (byte > 1) fail("contains a mark other than 0 and 1");
    value = byte == 1;
  }
  void item(std::string& text) { text = next(count(1)); }
  template <class T>
  void item(std::vector<T>& values) {
    if constexpr (is_plain_value<T>) {
      const std::size_t size = count(sizeof(T));
      values.resize(size);
      if (size > 0) std::memcpy(values.data(), next(size * sizeof(T)).data(), size * sizeof(T));
    } else {
      values.clear();
      for (std::size_t left = count(1); left > 0; --left) item(values.emplace_back());
    }
  }
  template <class T>
  void item(std::optional<T>& value) {
    bool has = false;
    item(has);
    value.reset();
    if (has) item(value.emplace());
  }
  /// Reads a value of type T.
  template <class T>
  T get() {
    T value{};
    item(value);
    return value;
  }
  void done() const {
    if (at_ != bytes_.size()) fail("is longer than its contents");
  }
  [[nodiscard]] const std::string& owner() const { return owner_; }
  [[noreturn]] void fail(std::string_view what) const {
    throw InputError(owner_ + " " + std::string(what) + "; take an earlier one");
  }

 private:
  /// Reads the number of items that follow, each of at least `each` bytes.
  std::size_t count(std::size_t each) {
    const auto announced = get<std::uint64_t>();
    if (announced > (bytes_.size() - at_) / each) fail("is too short for its contents");
    return static_cast<std::size_t>(announced);
  }
  std::string_view next(std::size_t size) {
    if (size > bytes_.size() - at_) fail("is too short for its contents");
    return bytes_.substr(std::exchange(at_, at_ + size), size);
  }

  std::string_view bytes_;
  std::size_t at_ = 0;
  std::string owner_;
};

}  // namespace trilith
