#include "model/io/checkpoint.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <span>
#include <string>
#include <system_error>

#include "base/error.hpp"
#include "base/fresh_file.hpp"
#include "base/hash.hpp"
#include "model/io/fingerprint.hpp"
#include "model/io/state_words.hpp"

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
  if (!in || first != magic()) throw InputError(title(path) + " is not a checkpoint: it does not begin with TRILSTAT");
  if (bytes % 8 != 0 || bytes < static_cast<std::streamoff>(8 * (head_words + 1)))
    throw InputError(title(path) + " is cut off; use an earlier one");
  std::vector<std::uint64_t> words(static_cast<std::size_t>(bytes) / 8);
  in.seekg(0);
  in.read(reinterpret_cast<char*>(words.data()), bytes);
  if (!in) throw InputError(fmt::format("{} cannot be read: {}", title(path), std::strerror(errno)));
  return words;
}

void check_head(std::span<const std::uint64_t> words, const std::filesystem::path& path, std::uint64_t structure) {
  if (words[1] == swapped_mark)
    throw InputError(title(path) +
                     " was written on a machine with the other byte order; it can only be read on such a machine");
  if (words[1] != byte_order_mark) throw InputError(title(path) + " has a damaged header; use an earlier one");
  if (words[2] != checkpoint_version)
    throw InputError(fmt::format(
        "{} has version {} of the format, this program reads version {}; run it with the program that wrote it",
        title(path), words[2], checkpoint_version));
  if (words[5] != words.size() - head_words - 1)
    throw InputError(title(path) + " is cut off or has data after its end; use an earlier one");
  if (words.back() != digest(words.first(words.size() - 1)))
    throw InputError(title(path) + " is damaged: its digest does not match its contents; use an earlier one");
  if (words[3] != structure)
    throw InputError(
        title(path) +
        " belongs to another model: bodies, laws or bearings differ; load it with the model it was saved from");
}

/// After it is known which bodies have left, because these are held whatever the model states.
void check_conditions(std::span<const std::uint64_t> words, const std::filesystem::path& path,
                      std::uint64_t conditions) {
  if (words[4] != conditions)
    throw InputError(title(path) +
                     " belongs to this model with other supports, motions, gravity, damping or loads; set them as they "
                     "were when it was saved, and change them after loading");
}

}  // namespace

template <int D>
void save_state(const State<D>& state, const Model<D>& model, const std::filesystem::path& path) try {
  const Fingerprint print = model_fingerprint(model, state);
  const std::vector<std::uint64_t> contents = state_words(state);
  std::vector<std::uint64_t> words{magic(),         byte_order_mark,  checkpoint_version,
                                   print.structure, print.conditions, contents.size()};
  words.insert(words.end(), contents.begin(), contents.end());
  words.push_back(digest(words));
  FreshFile file(path);
  file.write({reinterpret_cast<const char*>(words.data()), words.size() * sizeof(words[0])});
  file.take_place();
} catch (const std::system_error& error) {
  throw InputError(fmt::format("{} cannot be written: {}", title(path), error.code().message()));
}

template <int D>
State<D> load_state(const Model<D>& model, const std::filesystem::path& path) {
  const std::vector<std::uint64_t> words = read_words(path);
  check_head(words, path, model_fingerprint(model).structure);
  const std::span<const std::uint64_t> all(words);
  const State<D> state = state_from_words(model, all.subspan(head_words, words.size() - head_words - 1), title(path));
  check_conditions(words, path, model_fingerprint(model, state).conditions);
  return state;
}

template void save_state(const State<2>&, const Model<2>&, const std::filesystem::path&);
template void save_state(const State<3>&, const Model<3>&, const std::filesystem::path&);
template State<2> load_state(const Model<2>&, const std::filesystem::path&);
template State<3> load_state(const Model<3>&, const std::filesystem::path&);

}  // namespace trilith
