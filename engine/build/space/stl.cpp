#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "base/error.hpp"
#include "base/whole_file.hpp"
#include "build/space/solid_file.hpp"

namespace trilith {
namespace {

/// A binary file: 80 arbitrary bytes, the number of triangles, and 50 bytes for each: normal, three corners in single
/// precision, two bytes.
constexpr std::size_t stl_head = 84, stl_triangle = 50;

std::uint32_t whole_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k)
    value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + k])) << (8 * k);
  return value;
}

/// Number of bytes after the triangles of a binary file, because some programs pad their files; negative for a text and
/// for a truncated file.
std::ptrdiff_t bytes_behind(std::string_view bytes) {
  if (bytes.size() < stl_head) return -1;
  const auto rest = static_cast<std::ptrdiff_t>(bytes.size() - stl_head) -
                    static_cast<std::ptrdiff_t>(stl_triangle * std::size_t{whole_at(bytes, 80)});
  const bool padded = rest > 0 && whole_at(bytes, 80) > 0 && bytes.find('\0') != std::string_view::npos;
  return rest == 0 || padded ? rest : -1;
}

/// The text without empty lines before it, and without the bytes (Ctrl-Z, zeros) that some programs append.
std::string_view stl_text(std::string_view bytes) {
  constexpr std::string_view behind("\x1a\0 \t\r\n", 6);
  const std::size_t last = bytes.find_last_not_of(behind);
  return last == std::string_view::npos ? std::string_view() : bytes.substr(0, last + 1);
}

/// Rejects a file that is neither binary nor a text with the required begin. Many binary files begin with "solid" too,
/// but contain zero bytes.
void refuse_damaged(std::string_view bytes, std::string_view owner) {
  const std::size_t first = std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size());
  std::string word(bytes.substr(first, bytes.find_first_of(" \t\r\n", first) - first));
  for (char& c : word)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  const bool says_solid = word == "solid";
  const bool is_text = bytes.find('\0') == std::string_view::npos;
  if (says_solid && is_text) return;
  if (is_text || bytes.size() < stl_head)
    throw InputError(
        fmt::format("{}: is not an STL file: a text file begins with 'solid', and a binary one has {} bytes before its "
                    "first triangle",
                    owner, stl_head));
  const std::size_t triangles = whole_at(bytes, 80), room = (bytes.size() - stl_head) / stl_triangle;
  throw InputError(
      fmt::format("{}: is cut short or not an STL file: bytes 81 to 84 announce {} triangles, which need {} bytes, but "
                  "it has {}, room for {}; export it again",
                  owner, triangles, stl_head + stl_triangle * triangles, bytes.size(), room));
}

void add_triangle(Polyhedron& surface, const std::array<Vec3, 3>& corners) {
  const int first = static_cast<int>(surface.corners.size());
  surface.corners.insert(surface.corners.end(), corners.begin(), corners.end());
  surface.faces.add(std::array{first, first + 1, first + 2});
}

std::vector<NamedSurfaces> binary_stl(std::string_view bytes, const FileAxes& axes, std::string_view owner) {
  NamedSurfaces body;
  Polyhedron surface;
  const std::uint32_t triangles = whole_at(bytes, 80);
  for (std::uint32_t t = 0; t < triangles; ++t) {
    std::array<double, 9> n;
    for (std::size_t k = 0; k < 9; ++k) {
      const std::uint32_t word = whole_at(bytes, stl_head + stl_triangle * t + 12 + 4 * k);
      float value = 0;
      std::memcpy(&value, &word, sizeof value);
      if (!std::isfinite(value))
        throw InputError(fmt::format("{}: triangle {} has a corner that is not finite", owner, t + 1));
      n[k] = static_cast<double>(value);
    }
    const std::array<Vec3, 3> corners{axes.place(n[0], n[1], n[2]), axes.place(n[3], n[4], n[5]),
                                      axes.place(n[6], n[7], n[8])};
    for (const Vec3& p : corners)
      if (const std::string why = why_beyond_reach(p); !why.empty())
        throw InputError(fmt::format("{}: triangle {} has {}", owner, t + 1, why));
    add_triangle(surface, corners);
  }
  if (surface.faces.count() > 0) body.surfaces.push_back(std::move(surface));
  return {body};
}

/// Reads the words of a text and tracks the line number.
class StlText {
 public:
  StlText(std::string_view text, const FileAxes& axes, std::string_view owner)
      : text_(text), axes_(axes), owner_(owner) {}

  std::vector<NamedSurfaces> run() {
    std::vector<NamedSurfaces> bodies;
    while (!at_end()) bodies.push_back(solid());
    return bodies;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}: line {}: {}", owner_, line_, what));
  }
  static bool is_space(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
  bool at_end() {
    for (; at_ < text_.size() && is_space(text_[at_]); ++at_)
      if (text_[at_] == '\n') ++line_;
    return at_ >= text_.size();
  }
  std::string_view word() {
    if (at_end()) return {};
    const std::size_t from = at_;
    while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
    return text_.substr(from, at_ - from);
  }
  static std::string shown(std::string_view w) {
    std::string out(w.substr(0, 40));
    for (char& c : out)
      if (c < ' ' || c > '~') c = '?';
    return out;
  }
  static bool is_same(std::string_view w, std::string_view key) {
    return w.size() == key.size() && std::equal(w.begin(), w.end(), key.begin(), [](char a, char b) {
             return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
           });
  }
  void expect(std::string_view key) {
    const std::string_view w = word();
    if (!is_same(w, key))
      fail(w.empty() ? fmt::format("the file ends where '{}' should be", key)
                     : fmt::format("'{}' where '{}' should be", shown(w), key));
  }
  double number() {
    std::string_view w = word();
    const std::string_view whole = w;
    if (!w.empty() && w[0] == '+') w.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), value);
    if (w.empty() || error != std::errc() || end != w.data() + w.size() || !std::isfinite(value))
      fail(fmt::format("a coordinate is '{}', must be a finite number", shown(whole)));
    return value;
  }
  /// The rest of this line.
  std::string rest_of_line() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string_view rest = text_.substr(at_, end - at_);
    at_ = end;
    while (!rest.empty() && is_space(rest.front())) rest.remove_prefix(1);
    while (!rest.empty() && is_space(rest.back())) rest.remove_suffix(1);
    return std::string(rest);
  }

  NamedSurfaces solid() {
    expect("solid");
    NamedSurfaces body;
    body.name = rest_of_line();
    Polyhedron surface;
    for (std::string_view w = word(); !is_same(w, "endsolid"); w = word()) {
      if (!is_same(w, "facet"))
        fail(w.empty() ? std::string("the file ends before 'endsolid'")
                       : fmt::format("'{}' instead of 'facet' or 'endsolid'", shown(w)));
      add_triangle(surface, facet());
    }
    rest_of_line();
    if (surface.faces.count() > 0) body.surfaces.push_back(std::move(surface));
    return body;
  }

  /// Normals are skipped: many programs leave them 0.
  std::array<Vec3, 3> facet() {
    expect("normal");
    for (int k = 0; k < 3; ++k) word();
    expect("outer"), expect("loop");
    std::array<Vec3, 3> corners;
    for (Vec3& corner : corners) {
      expect("vertex");
      const double x = number(), y = number(), z = number();
      corner = axes_.place(x, y, z);
      if (const std::string why = why_beyond_reach(corner); !why.empty()) fail(why);
    }
    expect("endloop"), expect("endfacet");
    return corners;
  }

  std::string_view text_;
  const FileAxes& axes_;
  std::string owner_;
  std::size_t at_ = 0;
  int line_ = 1;
};

}  // namespace

SolidParts parse_stl(std::string_view bytes, const SolidFile& how, std::string_view owner) {
  const FileAxes axes(how, owner);
  if (const std::ptrdiff_t rest = bytes_behind(bytes); rest >= 0) {
    SolidParts made = solids_of_file(binary_stl(bytes, axes, owner), how, owner);
    if (rest > 0)
      made.notes.push_back(
          fmt::format("{}: {} bytes after its {} triangles are ignored", owner, rest, whole_at(bytes, 80)));
    return made;
  }
  const std::string_view text = stl_text(without_byte_order_mark(bytes));
  refuse_damaged(text.find('\0') == std::string_view::npos ? text : bytes, owner);
  return solids_of_file(StlText(text, axes, owner).run(), how, owner);
}

}  // namespace trilith
