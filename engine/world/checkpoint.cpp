#include "world/checkpoint.hpp"

#include <fmt/format.h>

#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "base/fresh_file.hpp"
#include "base/hash.hpp"
#include "world/fingerprint.hpp"

namespace trilith {
namespace {

constexpr std::uint64_t byte_order_mark = 0x0102030405060708;
constexpr std::uint64_t swapped_mark = 0x0807060504030201;
constexpr std::size_t head_words = 6;

std::uint64_t magic() {
  std::uint64_t word = 0;
  std::memcpy(&word, "TRILSTAT", sizeof word);
  return word;
}

std::uint64_t digest(std::span<const std::uint64_t> words) {
  Hash hash;
  for (const std::uint64_t w : words) hash.add(w);
  return hash.value();
}

constexpr std::uint64_t pack(std::uint32_t high, std::uint32_t low) {
  return std::uint64_t{high} << 32 | low;
}
constexpr std::uint32_t high_of(std::uint64_t word) {
  return static_cast<std::uint32_t>(word >> 32);
}
constexpr std::uint32_t low_of(std::uint64_t word) {
  return static_cast<std::uint32_t>(word);
}

/// Puts a state's parts into words, in the order of the header.
class Writer {
 public:
  std::vector<std::uint64_t> words;

  void number(double& v) { words.push_back(std::bit_cast<std::uint64_t>(v)); }
  void whole(std::int64_t& v) { words.push_back(std::bit_cast<std::uint64_t>(v)); }
  void key(ContactKey& v) { words.push_back(v); }
  void flag(std::uint8_t& v) { words.push_back(v); }
  template <class T, class U>
  void pair(T& high, U& low) {
    words.push_back(pack(static_cast<std::uint32_t>(high), static_cast<std::uint32_t>(low)));
  }
  std::size_t count(std::size_t n) {
    words.push_back(n);
    return n;
  }
};

/// Takes them out again; says what is wrong where they cannot be.
class Reader {
 public:
  Reader(std::span<const std::uint64_t> words, std::string owner) : words_(words), owner_(std::move(owner)) {}

  void number(double& v) {
    v = std::bit_cast<double>(next());
    if (!std::isfinite(v)) fail("holds a number that is not finite");
  }
  void whole(std::int64_t& v) {
    v = std::bit_cast<std::int64_t>(next());
    if (v < 0) fail("holds a negative number of steps");
  }
  void key(ContactKey& v) { v = next(); }
  void flag(std::uint8_t& v) {
    const std::uint64_t word = next();
    if (word > 1) fail("holds a mark that is neither 0 nor 1");
    v = static_cast<std::uint8_t>(word);
  }
  template <class T, class U>
  void pair(T& high, U& low) {
    const std::uint64_t word = next();
    high = static_cast<T>(high_of(word));
    low = static_cast<U>(low_of(word));
  }
  /// Reads a count that must be `expected`.
  std::size_t count(std::size_t expected) {
    const std::uint64_t n = next();
    if (n != expected) fail("has other numbers of rows than the model");
    return expected;
  }
  /// Reads a count of rows of at least `least` words each.
  std::size_t open_count(std::size_t least) {
    const std::uint64_t n = next();
    if (n > words_.size() / least) fail("is too short for what it announces");
    return static_cast<std::size_t>(n);
  }
  void done() const {
    if (at_ != words_.size()) fail("is longer than its contents");
  }
  [[noreturn]] void fail(std::string_view what) const {
    throw InputError(fmt::format("{} {}; it is damaged, take an earlier one", owner_, what));
  }

 private:
  std::uint64_t next() {
    if (at_ >= words_.size()) fail("is too short for what it announces");
    return words_[at_++];
  }
  std::span<const std::uint64_t> words_;
  std::size_t at_ = 0;
  std::string owner_;
};

// The order of the parts is written once: `walk` goes through a state for the writer and for the reader alike.

template <class W>
void walk(W& file, ContactMemory& m) {
  for (const int h : {0, 1}) file.number(m.shear_elastic[h]);
  for (const int h : {0, 1}) file.number(m.shear_total[h]);
  for (const int h : {0, 1}) file.number(m.damping_force[h]);
  for (const int h : {0, 1}) file.number(m.own[h]);
  for (const int h : {0, 1}) file.number(m.set[h]);
  for (const int h : {0, 1}) file.number(m.crushed[h]);
  for (const int h : {0, 1}) file.number(m.active[h]);
  file.number(m.slip);
  file.pair(m.bonds, m.state);
}

template <class W>
void walk(W& file, Parted& p) {
  file.key(p.contact);
  file.number(p.time);
}

template <class W>
void walk(W& file, BearingMemory& m) {
  file.pair(m.status, m.failed_direction);
  for (DirectionMemory& d : m.direction)
    for (double* v : {&d.inner, &d.force, &d.damping, &d.travelled, &d.compression}) file.number(*v);
}

template <class W>
void walk_clock(W& file, State<2>& s) {
  file.number(s.time);
  file.whole(s.step);
  file.number(s.dt);
  file.number(s.safety);
  file.number(s.last_dt);
}

template <class W>
void walk_nodes(W& file, State<2>& s) {
  const std::size_t nodes = file.count(s.position.size());
  for (std::size_t n = 0; n < nodes; ++n)
    for (double* v :
         {&s.position[n].x(), &s.position[n].y(), &s.rotation[n], &s.velocity[n].x(), &s.velocity[n].y(), &s.spin[n]})
      file.number(*v);
}

template <class W>
void walk_rest(W& file, State<2>& s) {
  for (std::size_t i = 0, n = file.count(s.bearing.size()); i < n; ++i) walk(file, s.bearing[i]);
  for (std::size_t i = 0, n = file.count(s.plastic.size()); i < n; ++i)
    for (double* v : {&s.plastic[i].xx, &s.plastic[i].yy, &s.plastic[i].zz, &s.plastic[i].xy, &s.plastic[i].measure})
      file.number(*v);
  for (std::size_t i = 0, n = file.count(s.seat_lost.size()); i < n; ++i) file.flag(s.seat_lost[i]);
  for (std::size_t i = 0, n = file.count(s.moved_at.size()); i < n; ++i) {
    file.number(s.moved_at[i]);
    file.flag(s.resting[i]);
  }
  for (std::size_t i = 0, n = file.count(s.left.size()); i < n; ++i) file.flag(s.left[i]);
  for (std::size_t i = 0, n = file.count(s.given.value.size()); i < n; ++i) file.number(s.given.value[i]);
}

std::vector<std::uint64_t> words_of(State<2> state, const Fingerprint& print) {
  Writer file;
  file.words = {magic(), byte_order_mark, checkpoint_version, print.structure, print.conditions, 0};
  walk_clock(file, state);
  walk_nodes(file, state);
  // Empty contacts come and go with the search for pairs and mean nothing.
  std::size_t kept = 0;
  for (const ContactMemory& m : state.memory) kept += m.empty() ? 0 : 1;
  file.count(kept);
  for (std::size_t i = 0; i < state.memory.size(); ++i) {
    if (state.memory[i].empty()) continue;
    file.key(state.contact[i]);
    walk(file, state.memory[i]);
  }
  file.count(state.parted.size());
  for (Parted& p : state.parted) walk(file, p);
  file.count(state.passed.size());
  for (ContactKey& bodies : state.passed) file.key(bodies);
  walk_rest(file, state);
  file.words[head_words - 1] = file.words.size() - head_words;
  file.words.push_back(digest(file.words));
  return file.words;
}

bool is_contact_of(const Model<2>& model, ContactKey key) {
  return first_piece(key) >= 0 && first_piece(key) < second_piece(key) && second_piece(key) < model.pieces();
}

void read_contacts(Reader& file, const Model<2>& model, State<2>& s) {
  const std::size_t count = file.open_count(17);
  s.contact.resize(count);
  s.memory.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    file.key(s.contact[i]);
    walk(file, s.memory[i]);
    if (!is_contact_of(model, s.contact[i]) || (i > 0 && s.contact[i - 1] >= s.contact[i]))
      file.fail("has a contact of pieces that are not there, or out of order");
    if (s.memory[i].empty() || s.memory[i].bonds > 3 ||
        s.memory[i].state > (contact_touching | contact_general | contact_worn | contact_crushed))
      file.fail("has a contact in no known state");
  }
}

void read_parted(Reader& file, const Model<2>& model, State<2>& s) {
  s.parted.resize(file.open_count(2));
  for (Parted& p : s.parted) {
    walk(file, p);
    if (!is_contact_of(model, p.contact)) file.fail("has a parted contact of pieces that are not there");
  }
}

void check_bearings(const Reader& file, const State<2>& s) {
  for (const BearingMemory& m : s.bearing)
    if (m.status > BearingStatus::changed || m.failed_direction > 2) file.fail("has a bearing in no known state");
}

void read_passed(Reader& file, const Model<2>& model, State<2>& s) {
  s.passed.resize(file.open_count(1));
  const int bodies = static_cast<int>(model.bodies.size());
  for (std::size_t i = 0; i < s.passed.size(); ++i) {
    file.key(s.passed[i]);
    const int a = first_piece(s.passed[i]), b = second_piece(s.passed[i]);
    if (a < 0 || a >= b || b >= bodies || (i > 0 && s.passed[i - 1] >= s.passed[i]))
      file.fail("has bodies that passed that are not there, or out of order");
  }
}

std::string title(const std::filesystem::path& path) {
  return fmt::format("checkpoint '{}'", path.string());
}

std::vector<std::uint64_t> read_words(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary | std::ios::ate);
  const std::streamoff bytes = in ? static_cast<std::streamoff>(in.tellg()) : -1;
  if (bytes < 0) throw InputError(fmt::format("{} cannot be read: {}", title(path), std::strerror(errno)));
  std::uint64_t first = 0;
  in.seekg(0);
  in.read(reinterpret_cast<char*>(&first), sizeof first);
  if (!in || first != magic()) throw InputError(title(path) + " is no checkpoint: it does not begin with TRILSTAT");
  if (bytes % 8 != 0 || bytes < static_cast<std::streamoff>(8 * (head_words + 1)))
    throw InputError(title(path) + " is cut off; take an earlier one");
  std::vector<std::uint64_t> words(static_cast<std::size_t>(bytes) / 8);
  in.seekg(0);
  in.read(reinterpret_cast<char*>(words.data()), bytes);
  if (!in) throw InputError(fmt::format("{} cannot be read: {}", title(path), std::strerror(errno)));
  return words;
}

void check_head(std::span<const std::uint64_t> words, const std::filesystem::path& path, std::uint64_t structure) {
  if (words[1] == swapped_mark)
    throw InputError(title(path) +
                     " was written on a machine of the other byte order; it can only be read on one of that kind");
  if (words[1] != byte_order_mark) throw InputError(title(path) + " has a damaged head; take an earlier one");
  if (words[2] != checkpoint_version)
    throw InputError(fmt::format(
        "{} has version {} of the format, this program reads version {}; run it with the program that wrote it",
        title(path), words[2], checkpoint_version));
  if (words[5] != words.size() - head_words - 1)
    throw InputError(title(path) + " is cut off or has something after its end; take an earlier one");
  if (words.back() != digest(words.first(words.size() - 1)))
    throw InputError(title(path) + " is damaged: its digest does not fit its contents; take an earlier one");
  if (words[3] != structure)
    throw InputError(
        title(path) +
        " belongs to another model: bodies, laws or bearings differ; load it with the model it was saved from");
}

/// Once it is known which bodies have left, as these are held whatever the model says.
void check_conditions(std::span<const std::uint64_t> words, const std::filesystem::path& path,
                      std::uint64_t conditions) {
  if (words[4] != conditions)
    throw InputError(title(path) +
                     " belongs to this model under other supports, motions, gravity, damping or loads; "
                     "set them as they were when it was saved, and change them after loading");
}

}  // namespace

void save_state(const State<2>& state, const Model<2>& model, const std::filesystem::path& path) try {
  const std::vector<std::uint64_t> words = words_of(state, model_fingerprint(model, state));
  FreshFile file(path);
  file.write({reinterpret_cast<const char*>(words.data()), words.size() * sizeof(words[0])});
  file.take_place();
} catch (const std::system_error& error) {
  throw InputError(fmt::format("{} cannot be written: {}", title(path), error.code().message()));
}

State<2> load_state(const Model<2>& model, const std::filesystem::path& path) {
  const std::vector<std::uint64_t> words = read_words(path);
  check_head(words, path, model_fingerprint(model).structure);
  State<2> state = initial_state(model);  // for the number of rows
  const std::span<const std::uint64_t> all(words);
  Reader file(all.subspan(head_words, words.size() - head_words - 1), title(path));
  walk_clock(file, state);
  walk_nodes(file, state);
  read_contacts(file, model, state);
  read_parted(file, model, state);
  read_passed(file, model, state);
  walk_rest(file, state);
  file.done();
  check_bearings(file, state);
  check_conditions(words, path, model_fingerprint(model, state).conditions);
  return state;
}

}  // namespace trilith
