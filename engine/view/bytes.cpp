#include "view/bytes.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <stdexcept>

namespace trilith::view {
namespace {

constexpr int gzip_window = 15 + 16;  // the largest window, with a gzip header
constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

void put(std::string& out, std::int64_t difference) {
  auto rest = static_cast<std::uint64_t>(difference < 0 ? -2 * difference - 1 : 2 * difference);
  for (; rest >= 128; rest >>= 7) out += static_cast<char>(static_cast<unsigned char>(rest | 128));
  out += static_cast<char>(rest);
}

// zlib only reads, but its old interface has no const.
Bytef* input(std::string_view bytes) {
  return reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
}

}  // namespace

std::int32_t quantised(double value, double quantum) {
  constexpr double most = 1 << 30;
  const double number = std::round(value / quantum);
  return std::isfinite(number) ? static_cast<std::int32_t>(std::clamp(number, -most, most)) : 0;
}

std::string packed(const ViewBlock& block) {
  std::string out;
  out.reserve(block.values.size());
  for (std::size_t c = 0; c < block.columns; ++c) {
    std::int64_t before = 0;
    for (std::size_t at = c; at < block.values.size(); at += block.columns) {
      put(out, block.values[at] - before);
      before = block.values[at];
    }
  }
  return out;
}

std::vector<std::int32_t> unpacked(std::string_view bytes, std::size_t rows, std::size_t columns) {
  std::vector<std::int32_t> values(rows * columns);
  std::size_t at = 0;
  for (std::size_t c = 0; c < columns; ++c) {
    std::int64_t value = 0;
    for (std::size_t r = 0; r < rows; ++r) {
      std::uint64_t number = 0;
      for (int shift = 0;; shift += 7) {
        assert(at < bytes.size());
        const auto byte = static_cast<unsigned char>(bytes[at++]);
        number |= static_cast<std::uint64_t>(byte & 127) << shift;
        if (byte < 128) break;
      }
      value += (number & 1) != 0 ? -static_cast<std::int64_t>((number + 1) / 2) : static_cast<std::int64_t>(number / 2);
      values[r * columns + c] = static_cast<std::int32_t>(value);
    }
  }
  assert(at == bytes.size());
  return values;
}

std::string gzipped(std::string_view bytes) {
  z_stream stream{};
  if (deflateInit2(&stream, 9, Z_DEFLATED, gzip_window, 9, Z_DEFAULT_STRATEGY) != Z_OK) throw std::bad_alloc();
  std::string out(deflateBound(&stream, bytes.size()) + 32, '\0');
  stream.next_in = input(bytes);
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  [[maybe_unused]] const int end = deflate(&stream, Z_FINISH);
  assert(end == Z_STREAM_END);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

std::string gunzipped(std::string_view bytes) {
  z_stream stream{};
  if (inflateInit2(&stream, gzip_window) != Z_OK) throw std::bad_alloc();
  stream.next_in = input(bytes);
  stream.avail_in = static_cast<uInt>(bytes.size());
  std::string out;
  std::array<char, 1 << 16> piece{};
  int state = Z_OK;
  while (state == Z_OK) {
    stream.next_out = reinterpret_cast<Bytef*>(piece.data());
    stream.avail_out = static_cast<uInt>(piece.size());
    state = inflate(&stream, Z_NO_FLUSH);
    out.append(piece.data(), piece.size() - stream.avail_out);
  }
  inflateEnd(&stream);
  if (state != Z_STREAM_END) throw std::runtime_error("not a complete gzip stream");
  return out;
}

std::string base64(std::string_view bytes) {
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) out += i + k > bytes.size() ? '=' : letters[three >> (18 - 6 * k) & 63];
  }
  return out;
}

std::string from_base64(std::string_view text) {
  std::string out;
  unsigned held = 0;
  int bits = 0;
  for (const char c : text) {
    const std::size_t value = letters.find(c);
    if (value == std::string_view::npos) continue;
    held = (held << 6 | static_cast<unsigned>(value)) & 0xffffff;
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    out += static_cast<char>(static_cast<unsigned char>(held >> bits & 255));
  }
  return out;
}

}  // namespace trilith::view
