#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <unordered_map>

#include "base/error.hpp"
#include "base/whole_file.hpp"
#include "build/space/solid_file.hpp"

namespace trilith {
namespace {

/// Faces of one object within one group, in the order of the file.
struct ObjPatch {
  int object, group;  ///< index of their names
  FaceLoops faces;    ///< of all points of the file
};

class ObjReader {
 public:
  ObjReader(std::string_view text, const SolidFile& how, std::string_view owner)
      : text_(text), owner_(owner), axes_(how, owner) {}

  /// The first object whose name appears twice; "" if none does.
  [[nodiscard]] const std::string& again() const { return again_; }

  std::vector<NamedSurfaces> run() {
    while (next_line()) {
      const std::string_view key = word();
      if (key == "v")
        point();
      else if (key == "f")
        face();
      else if (key == "o")
        begin_object(rest());
      else if (key == "g")
        group_ = groups_.of(rest()), current_ = -1;
    }
    return bodies();
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(fmt::format("{}: line {}: {}", owner_, number_, what));
  }

  /// The next line without its end and without a comment after #, including empty ones. A backslash at its end joins it
  /// with the line after it.
  bool next_line() {
    if (at_ >= text_.size()) return false;
    line_ = one_line();
    if (!goes_on(line_)) return true;
    joined_.clear();
    for (;; line_ = one_line()) {
      const bool more = goes_on(line_) && at_ < text_.size();
      joined_ += line_.substr(0, goes_on(line_) ? line_.rfind('\\') : line_.size());
      joined_ += ' ';
      if (!more) break;
    }
    line_ = joined_;
    return true;
  }
  std::string_view one_line() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    const std::string_view line = text_.substr(at_, end - at_);
    at_ = end + 1, ++number_;
    return line.substr(0, line.find('#'));
  }
  static bool goes_on(std::string_view line) {
    const std::size_t last = line.find_last_not_of(" \t\r");
    return last != std::string_view::npos && line[last] == '\\';
  }

  /// An object with an earlier name adds to the faces of that object.
  void begin_object(const std::string& name) {
    const std::size_t known = objects_.list.size();
    object_ = objects_.of(name), current_ = -1;
    if (static_cast<std::size_t>(object_) < known && again_.empty())
      again_ = fmt::format(
          "{}: line {}: object '{}' appears again; its faces are added to the earlier ones, as one body. Give it its "
          "own name, or set shells_are_bodies to make each closed shell a body",
          owner_, number_, name);
  }

  std::string_view word() {
    const auto from = line_.find_first_not_of(" \t\r");
    if (from == std::string_view::npos) return line_ = {};
    const auto end = std::min(line_.find_first_of(" \t\r", from), line_.size());
    const std::string_view found = line_.substr(from, end - from);
    line_ = line_.substr(end);
    return found;
  }

  std::string rest() {
    std::string all;
    for (std::string_view w = word(); !w.empty(); w = word()) {
      if (!all.empty()) all += ' ';
      all += w;
    }
    return all;
  }

  /// Names and the number of each.
  struct ObjNames {
    std::vector<std::string> list;
    std::unordered_map<std::string, int> number;
    int of(const std::string& name) {
      const auto [place, is_new] = number.emplace(name, static_cast<int>(list.size()));
      if (is_new) list.push_back(name);
      return place->second;
    }
  };

  double number(const char* what) {
    std::string_view w = word();
    if (!w.empty() && w[0] == '+') w.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), value);
    if (w.empty() || error != std::errc() || end != w.data() + w.size() || !std::isfinite(value))
      fail(fmt::format("{} of a point is '{}', must be a finite number", what, w.substr(0, 40)));
    return value;
  }

  void point() {
    const double x = number("x"), y = number("y"), z = number("z");
    points_.push_back(axes_.place(x, y, z));
    if (const std::string why = why_beyond_reach(points_.back()); !why.empty()) fail(why);
  }

  /// Index of a corner such as 7, 7/1, 7//3, 7/1/3, or -1 for the last point so far.
  int index(std::string_view w) const {
    w = w.substr(0, w.find('/'));
    int i = 0;
    const auto [end, error] = std::from_chars(w.data(), w.data() + w.size(), i);
    const int count = static_cast<int>(points_.size());
    if (error != std::errc() || end != w.data() + w.size())
      fail(fmt::format("a corner of a face is '{}', must be the number of a point", w.substr(0, 40)));
    if (count == 0) fail(fmt::format("a face names point {}, but no point precedes it", i));
    if (i == 0 || i > count || i < -count)
      fail(fmt::format("a face names point {}, there are points 1 to {} so far", i, count));
    return i > 0 ? i - 1 : count + i;
  }

  void face() {
    std::vector<int> loop;
    for (std::string_view w = word(); !w.empty(); w = word()) loop.push_back(index(w));
    if (loop.size() < 3) fail(fmt::format("a face has {} corners, at least 3 are needed", loop.size()));
    if (current_ < 0) {
      const auto [place, is_new] = patch_of_.emplace(std::pair(object_, group_), static_cast<int>(patches_.size()));
      if (is_new) patches_.push_back({object_, group_, {}});
      current_ = place->second;
    }
    patches_[static_cast<std::size_t>(current_)].faces.add(loop);
  }

  /// Surface of some patches, with their points only.
  [[nodiscard]] Polyhedron surface(const std::vector<const ObjPatch*>& of) const {
    Polyhedron made;
    std::unordered_map<int, int> number;
    for (const ObjPatch* patch : of)
      for (int f = 0; f < patch->faces.count(); ++f) {
        std::vector<int> loop;
        for (const int i : patch->faces[f]) {
          const auto [place, is_new] = number.emplace(i, static_cast<int>(made.corners.size()));
          if (is_new) made.corners.push_back(points_[static_cast<std::size_t>(i)]);
          loop.push_back(place->second);
        }
        made.faces.add(loop);
      }
    return made;
  }

  /// True if a named group contains faces of several objects.
  [[nodiscard]] bool groups_hold_objects() const {
    std::unordered_map<int, int> object;
    for (const ObjPatch& patch : patches_)
      if (patch.group >= 0 && object.emplace(patch.group, patch.object).first->second != patch.object) return true;
    return false;
  }

  [[nodiscard]] std::vector<NamedSurfaces> bodies() const {
    const bool by_group = objects_.list.empty() || groups_hold_objects();
    std::vector<NamedSurfaces> made;
    std::unordered_map<int, std::size_t> body;                     // of object or group
    std::vector<std::vector<std::vector<const ObjPatch*>>> parts;  // [body][surface]
    for (const ObjPatch& patch : patches_) {
      const int key = by_group ? patch.group : patch.object;
      const auto [place, is_new] = body.emplace(key, made.size());
      if (is_new) made.push_back(named(key, by_group)), parts.emplace_back();
      auto& surfaces = parts[place->second];
      if (surfaces.empty() || by_group) surfaces.emplace_back();  // each object of a group is closed separately
      surfaces.back().push_back(&patch);
      if (!by_group && patch.group >= 0)
        add_groups(made[place->second], groups_.list[static_cast<std::size_t>(patch.group)]);
    }
    for (std::size_t b = 0; b < made.size(); ++b)
      for (const auto& of : parts[b]) made[b].surfaces.push_back(surface(of));
    return made;
  }

  static void add_groups(NamedSurfaces& body, std::string_view names) {
    while (!names.empty()) {
      const std::size_t end = std::min(names.find(' '), names.size());
      const std::string name(names.substr(0, end));
      if (name != "default" && name != "off" &&
          std::find(body.groups.begin(), body.groups.end(), name) == body.groups.end())
        body.groups.push_back(name);
      names = end < names.size() ? names.substr(end + 1) : std::string_view{};
    }
  }

  /// A group with several names is called by the first of them.
  [[nodiscard]] NamedSurfaces named(int key, bool by_group) const {
    NamedSurfaces body;
    if (key < 0) return body;
    body.name = (by_group ? groups_ : objects_).list[static_cast<std::size_t>(key)];
    if (by_group) {
      add_groups(body, body.name);
      body.name = body.name.substr(0, body.name.find(' '));
    }
    return body;
  }

  std::string_view text_, line_;
  std::string owner_, joined_, again_;
  FileAxes axes_;
  std::size_t at_ = 0;
  int number_ = 0, object_ = -1, group_ = -1;
  std::vector<Vec3> points_;
  ObjNames objects_, groups_;
  std::vector<ObjPatch> patches_;
  std::map<std::pair<int, int>, int> patch_of_;  ///< by object and group
  int current_ = -1;                             ///< patch of the next faces, -1: to be determined
};

}  // namespace

SolidParts parse_obj(std::string_view text, const SolidFile& how, std::string_view owner) {
  constexpr std::string_view behind("\x1a\0 \t\r\n", 6);  // bytes that some programs append to a file
  text = text.substr(0, text.find_last_not_of(behind) + 1);
  if (const std::size_t zero = text.find('\0'); zero != std::string_view::npos)
    throw InputError(fmt::format("{}: is not an OBJ file: its byte {} is 0, but OBJ files are text; save it as OBJ",
                                 owner, zero + 1));
  ObjReader reader(without_byte_order_mark(text), how, owner);
  SolidParts made = solids_of_file(reader.run(), how, owner);
  if (!reader.again().empty()) made.notes.push_back(reader.again());
  return made;
}

}  // namespace trilith
