// trilith live RESULT [--port N]
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>

#include "base/error.hpp"
#include "program/local_server.hpp"
#include "program/since_option.hpp"
#include "program/verbs.hpp"
#include "results/file/part_path.hpp"
#include "view/data.hpp"
#include "view/live_page.hpp"

namespace trilith::program {
namespace {

struct LiveOptions {
  std::string result, since;
  int port = 0;
};

/// The file that a run writes at present; otherwise the last complete one.
results::ResultsReader latest_results(const std::string& path) {
  results::ResultsReader reader(path);
  if (reader.newer_part_running()) return results::ResultsReader(results::part_path(path));
  return reader;
}

/// The page of a run, made again when the file has more frames.
class LivePage {
 public:
  explicit LivePage(const LiveOptions& options) : options_(options) {}

  Reply answer(const std::string& path) {
    if (path == "/state") return {200, "text/plain; charset=utf-8", stamp()};
    if (path != "/") return {404, "text/plain; charset=utf-8", "there is only the page /\n"};
    stamp();
    return {200, "text/html; charset=utf-8", page_};
  }

 private:
  using Clock = std::chrono::steady_clock;

  /// Frames and state of the file, of which the page is made. A page that takes long to make is made more seldom, so
  /// that the run keeps most of the processor.
  const std::string& stamp() {
    if (Clock::now() < next_look_) return stamp_;
    const auto began = Clock::now();
    try {
      look();
    } catch (const std::exception& failure) {  // no file yet, or one without anything to show
      wait(failure.what());
    }
    next_look_ = Clock::now() + std::max<Clock::duration>(std::chrono::milliseconds(500), 4 * (Clock::now() - began));
    return stamp_;
  }

  void look() {
    const results::ResultsReader reader = latest_results(options_.result);
    const std::string state = reader.finished() ? "ended" : reader.running() ? "running" : "stopped";
    const std::string now = fmt::format("{} {} {}", reader.header().provenance.start_time, reader.frame_count(), state);
    if (now == stamp_) return;
    const results::TimeOrigin origin = results::time_origin(reader, options_.since);
    page_ =
        view::live_page(view::view_page(view::view_data(reader, {}, {}, origin, reader.units()), reader.title()), now);
    stamp_ = now;
  }

  void wait(const std::string& why) {
    const std::string now = "waiting: " + why;
    if (now == stamp_) return;
    page_ = view::waiting_page(fmt::format("Waiting for results in {}: {}", options_.result, why), now);
    stamp_ = now;
  }

  LiveOptions options_;
  std::string stamp_, page_;
  Clock::time_point next_look_{};
};

int live(const LiveOptions& options) {
  const LocalServer server(options.port);
  fmt::print("http://127.0.0.1:{}/ follows {}; Ctrl-C ends it\n", server.port(), options.result);
  std::fflush(stdout);
  LivePage page(options);
  server.serve([&page](const std::string& path) { return page.answer(path); });
}

}  // namespace

void add_live(CLI::App& app, int& code) {
  auto o = std::make_shared<LiveOptions>();
  CLI::App* verb = app.add_subcommand("live", "Show a run in a browser of this machine while it is computed");
  verb->add_option("result", o->result, "results file that a run writes, or will write")
      ->required()
      ->type_name("RESULT");
  verb->add_option("--port", o->port, "port of this machine; default a free one")
      ->check(CLI::Range(0, 65535))
      ->type_name("NUMBER");
  add_since(*verb, o->since);
  verb->callback([o, &code] { code = live(*o); });
}

}  // namespace trilith::program
