#include "bindings/restart/restart_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "base/bytes.hpp"
#include "base/hash.hpp"
#include "base/whole_file.hpp"
#include "results/file/provenance.hpp"

namespace trilith::script {
namespace {

constexpr std::string_view magic = "TRILITH RESTART\n";
constexpr std::uint32_t byte_order_mark = 0x01020304;
constexpr std::size_t head = magic.size() + 2 * sizeof(std::uint32_t);

/// Reads eight bytes at a time, so that it costs less than the write.
std::uint64_t digest(std::string_view bytes) {
  Hash hash;
  for (; bytes.size() >= 8; bytes.remove_prefix(8)) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data(), 8);
    hash.add(word);
  }
  hash.add(bytes);
  return hash.value();
}

std::string framed(std::string_view bytes) {
  ByteWriter out;
  out.item(byte_order_mark), out.item(restart_version);
  std::string all(magic);
  all += out.take();
  all += bytes;
  ByteWriter end;
  end.item(digest(all));
  return all + end.take();
}

std::string unframed(std::string bytes, const std::string& title) {
  const auto refuse = [&](const std::string& why) { throw InputError(title + " " + why); };
  if (!bytes.starts_with(magic)) refuse("is not a restart file: it begins with other bytes");
  if (bytes.size() < head + 8) refuse("is cut off");
  ByteReader in(std::string_view(bytes).substr(magic.size(), head - magic.size()), title);
  if (in.get<std::uint32_t>() != byte_order_mark) refuse("was written on a machine of the other byte order");
  if (const auto version = in.get<std::uint32_t>(); version != restart_version)
    refuse(
        fmt::format("has version {} of the format, and this program reads version {}; resume with the program that "
                    "wrote it",
                    version, restart_version));
  std::uint64_t stored = 0;
  std::memcpy(&stored, bytes.data() + bytes.size() - 8, 8);
  bytes.resize(bytes.size() - 8);
  if (digest(bytes) != stored) refuse("is cut off or damaged: its digest does not fit its contents");
  bytes.erase(0, head);
  return bytes;
}

/// `what`: "restart file".
std::string contents_of(const std::filesystem::path& path, std::string_view what) {
  constexpr std::size_t no_limit = std::string::npos;
  return unframed(text_of_file(path, what, no_limit), fmt::format("{} '{}'", what, path.string()));
}

}  // namespace

std::filesystem::path restart_folder(const std::filesystem::path& results) {
  std::filesystem::path folder = results;
  folder += ".restart";
  return folder;
}

std::filesystem::path kept_rows(const RestartFiles& files) {
  return files.folder() / "rows.h5";
}

std::string this_build() {
  return fmt::format("{} {}", TRILITH_VERSION, results::built_from());
}

void RestartFiles::put(const std::string& name, std::string bytes) {
  // Newer contents are written after all that they follow, also where an earlier store failed.
  std::erase(order_, name);
  order_.push_back(name);
  waits_[name] = std::move(bytes);
}

void RestartFiles::store() {
  if (folder_.empty() || order_.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  while (!order_.empty()) {
    const std::string name = order_.front();
    write_whole_file(path_of(name), framed(waits_.at(name)));
    order_.erase(order_.begin());
    waits_.erase(name);
  }
}

bool RestartFiles::has(const std::string& name) const {
  std::error_code error;
  return waits_.count(name) > 0 || (!folder_.empty() && std::filesystem::exists(path_of(name), error));
}

std::string RestartFiles::get(const std::string& name) const {
  if (const auto waiting = waits_.find(name); waiting != waits_.end()) return waiting->second;
  return contents_of(path_of(name), "restart file");
}

void RestartFiles::remove_all() {
  std::error_code error;
  if (folder_.empty() || !std::filesystem::is_directory(folder_, error)) return;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, error)) {
    const std::string name = entry.path().filename().string();
    const bool own = name == "call" || name == "rows.h5" || name.starts_with("stage-") || name.starts_with("at-") ||
                     name.starts_with("change-") || name.ends_with(".new");
    if (own) std::filesystem::remove(entry.path(), error);
  }
  std::filesystem::remove(folder_, error);  // fails if it contains other files
}

void RestartFiles::save_as(const std::filesystem::path& file, const std::vector<std::string>& names) const {
  ByteWriter out;
  out.item(names);
  for (const std::string& name : names) out.item(get(name));
  write_whole_file(file, framed(out.take()));
}

RestartFiles RestartFiles::opened(const std::filesystem::path& file) {
  const std::string bytes = contents_of(file, "saved instant");
  ByteReader in(bytes, fmt::format("saved instant '{}'", file.string()));
  RestartFiles files;
  for (const std::string& name : in.get<std::vector<std::string>>()) files.put(name, in.get<std::string>());
  in.done();
  return files;
}

}  // namespace trilith::script
