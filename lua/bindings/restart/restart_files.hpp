// The files of a restart folder, RESULT.restart/. Each file is either complete or absent. No Lua here.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trilith::script {

/// Version of the format of restart files; files of another version are refused.
inline constexpr std::uint32_t restart_version = 3;

/// `<results file>.restart`
std::filesystem::path restart_folder(const std::filesystem::path& results);

/// How the script was run; stored in the file `call` of the folder.
struct RestartCall {
  std::string build;               ///< version and commit of the program
  std::string folder;              ///< working directory of the run
  std::string script;              ///< path as given
  std::string text;                ///< of the script
  std::string named_results;       ///< results file given on the command line, or ""
  std::string case_folder;         ///< of a study, or ""
  std::vector<std::string> given;  ///< parameters
  std::string room;                ///< options of the sandbox, as bytes
  int number = 0;                  ///< case of a study, or 0
  int threads = 0;
  double every = 0;        ///< wall clock between checkpoints [s]
  std::string own_folder;  ///< of the checkpoints, as the run wrote them; "" in memory
};

/// Version and commit of this program.
std::string this_build();

/// Named byte strings in a folder. Those added by put() stay in memory until store(). A saved instant is one file with
/// all of them.
class RestartFiles {
 public:
  RestartFiles() = default;
  explicit RestartFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Sets the contents of `name`.
  void put(const std::string& name, std::string bytes);
  /// Writes the files in memory to the disk, in the order of put(): each under a temporary name, which is then renamed.
  /// Throws InputError if that fails; earlier files stay, and the remaining ones stay in memory.
  void store();
  [[nodiscard]] bool has(const std::string& name) const;
  /// Throws InputError if the file is absent, cut, damaged, or of another version.
  [[nodiscard]] std::string get(const std::string& name) const;
  /// Removes the folder and all restart files in it.
  void remove_all();
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  /// Writes the named files to one file. Throws InputError.
  void save_as(const std::filesystem::path& file, const std::vector<std::string>& names) const;
  /// Reads such a file. Its contents stay in memory and are never stored.
  static RestartFiles opened(const std::filesystem::path& file);

 private:
  [[nodiscard]] std::filesystem::path path_of(const std::string& name) const { return folder_ / name; }

  std::filesystem::path folder_;
  std::vector<std::string> order_;  // of the files in memory
  std::map<std::string, std::string> waits_;
};

/// The rows of the interrupted run, until they are copied to the new file.
std::filesystem::path kept_rows(const RestartFiles& files);

template <class File>
void each_field(File& file, RestartCall& c) {
  file.item(c.build), file.item(c.folder), file.item(c.script), file.item(c.text), file.item(c.named_results);
  file.item(c.case_folder), file.item(c.given), file.item(c.room), file.item(c.number), file.item(c.threads);
  file.item(c.every), file.item(c.own_folder);
}

/// Whether runs write checkpoints, and whether models continue from them.
struct RestartChoice {
  double every = 0;                          ///< wall clock between checkpoints [s]; 0: none
  bool resumes = false;                      ///< models continue from their restart folders
  bool in_memory = false;                    ///< in a console: checkpoints stay in memory, for saved instants
  bool script_ended = false;                 ///< further stages are typed at the console
  std::shared_ptr<const RestartFiles> from;  ///< a saved instant instead of restart folders
  RestartCall call;                          ///< of this run
};

}  // namespace trilith::script
