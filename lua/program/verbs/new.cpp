// trilith new [KIND] [FOLDER]
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "base/whole_file.hpp"
#include "bindings/core/host.hpp"
#include "program/verbs.hpp"

namespace trilith::program {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_template = 1000000;  // [bytes]

/// The folder of the starting models, as record_folders.
fs::path templates_folder() {
  std::vector<fs::path> places;
  if (const fs::path prefix = script::installed_under(); !prefix.empty())
    places.push_back(prefix / TRILITH_DATA / "trilith/examples/templates");
  places.emplace_back(TRILITH_INSTALLED_TEMPLATES);
  places.emplace_back(TRILITH_SOURCE_TEMPLATES);
  std::error_code error;
  for (const fs::path& place : places)
    if (fs::is_directory(place, error)) return place;
  throw InputError(
      fmt::format("new: there is no folder {} with the starting models; trilith doctor checks the "
                  "installation",
                  places.back().string()));
}

std::vector<std::string> template_names(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder))
    if (entry.is_directory()) names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  return names;
}

/// The first heading of a README, without its mark.
std::string heading_of(const fs::path& readme) {
  const std::string text = text_of_file(readme, "starting model", largest_template);
  const std::string line = text.substr(0, text.find('\n'));
  return line.starts_with("# ") ? line.substr(2) : line;
}

void list_templates(const fs::path& folder) {
  fmt::print("trilith new NAME [FOLDER] writes a starting model and a README:\n");
  for (const std::string& name : template_names(folder))
    fmt::print("  {:<8} {}\n", name, heading_of(folder / name / "README.md"));
}

/// The files of a template; none of them may exist in `to`.
std::vector<fs::path> files_to_copy(const fs::path& from, const fs::path& to) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(from)) files.push_back(entry.path());
  std::ranges::sort(files);
  for (const fs::path& file : files)
    if (fs::exists(fs::symlink_status(to / file.filename())))
      throw InputError(fmt::format("new: '{}' exists already; name another folder, or move the file away",
                                   (to / file.filename()).string()));
  return files;
}

int write_template(const std::string& kind, const std::string& folder) {
  const fs::path templates = templates_folder();
  if (kind.empty()) {
    list_templates(templates);
    return ended_well;
  }
  const std::vector<std::string> names = template_names(templates);
  if (std::ranges::find(names, kind) == names.end())
    throw InputError(fmt::format("new: there is no starting model '{}'{}", kind, name_hint(kind, names)));
  const fs::path to = folder.empty() ? kind : folder;
  const std::vector<fs::path> files = files_to_copy(templates / kind, to);
  std::error_code error;
  fs::create_directories(to, error);
  if (error) throw InputError(fmt::format("new: cannot make the folder '{}': {}", to.string(), error.message()));
  for (const fs::path& file : files) {
    write_whole_file(to / file.filename(), text_of_file(file, "starting model", largest_template));
    fmt::print("{}\n", (to / file.filename()).string());
  }
  fmt::print("next: cd {} && trilith run model.lua; README.md has the results to expect\n", to.string());
  return ended_well;
}

}  // namespace

void add_new(CLI::App& app, int& code) {
  struct NewOptions {
    std::string kind, folder;
  };
  auto o = std::make_shared<NewOptions>();
  CLI::App* verb = app.add_subcommand("new", "Write a commented starting model with a README");
  verb->add_option("name", o->kind, "arch, bridge, facade, frame, house3d or wall; without it, the list")
      ->type_name("NAME");
  verb->add_option("folder", o->folder, "folder for the files, made if necessary; default NAME")->type_name("FOLDER");
  verb->callback([o, &code] { code = write_template(o->kind, o->folder); });
}

}  // namespace trilith::program
