// trilith view RESULT [-o FILE]
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>

#include "base/error.hpp"
#include "record/view_data.hpp"
#include "screen.hpp"
#include "verbs.hpp"

namespace trilith::program {
namespace {

struct Options {
  std::string result, out;
};

/// Tells how far it is, where there is a terminal and more than a moment has gone by.
class ViewStatus {
 public:
  void operator()(double share) {
    const auto now = std::chrono::steady_clock::now();
    if (now - shown_ < std::chrono::milliseconds(200)) return;
    shown_ = now;
    screen_.status(fmt::format("reading frames  {:.0f} %", 100 * share));
  }
  void clear() { screen_.clear(); }

 private:
  Screen screen_{stderr};
  std::chrono::steady_clock::time_point shown_ = std::chrono::steady_clock::now();
};

/// The page takes its name when it is whole.
void write_page(const std::filesystem::path& path, const std::string& page) {
  const std::filesystem::path fresh = path.string() + ".new";
  std::ofstream stream(fresh, std::ios::binary);
  stream << page;
  stream.close();
  std::error_code error;
  if (stream) std::filesystem::rename(fresh, path, error);
  if (stream && !error) return;
  std::error_code ignored;
  std::filesystem::remove(fresh, ignored);
  throw InputError(fmt::format("'{}' cannot be written: is there such a folder, and room on the disk?", path.string()));
}

int view(const Options& options) {
  const std::filesystem::path out = options.out.empty()
                                        ? std::filesystem::path(options.result).replace_extension(".html")
                                        : std::filesystem::path(options.out);
  if (out.extension() != ".html" && out.extension() != ".htm")
    throw InputError(fmt::format("'{}': a page to view ends with .html", out.string()));
  const record::ResultsReader reader(options.result);
  ViewStatus status;
  const std::string data = record::view_data(reader, {}, [&](double share) { status(share); });
  status.clear();
  const std::string title = std::filesystem::path(options.result).stem().string();
  write_page(out, record::view_page(data, title));
  fmt::print("{}\n", out.string());
  if (!reader.finished())
    fmt::print("the run {}: the page holds what it had written\n", reader.running() ? "still goes on" : "was stopped");
  return ended_well;
}

}  // namespace

void add_view(CLI::App& app, int& code) {
  auto o = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand("view", "Write a page that plays the run in any browser");
  verb->add_option("result", o->result, "results file, also of a run that was killed or still goes on")
      ->required()
      ->type_name("RESULT");
  verb->add_option("-o,--output", o->out, "the page, .html; RESULT with .html where not given")->type_name("FILE");
  verb->callback([o, &code] { code = view(*o); });
}

}  // namespace trilith::program
