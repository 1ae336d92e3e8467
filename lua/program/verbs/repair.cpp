// trilith repair RESULT -o FILE
#include <fmt/format.h>

#include <memory>
#include <string>

#include "program/output_folder.hpp"
#include "program/verbs.hpp"
#include "results/reading/reader.hpp"

namespace trilith::program {
namespace {

struct RepairOptions {
  std::string result, out;
};

/// Number of readable frames among the written ones, and the error of the first other one.
struct Readable {
  std::size_t count = 0, written = 0;
  std::string why;
};
Readable readable_frames(const results::ResultsReader& reader) {
  Readable found{0, reader.frame_count(), ""};
  for (std::size_t i = 0; i < found.written; ++i) try {
      reader.frame(i);
      ++found.count;
    } catch (const results::ResultsError& error) {
      if (found.why.empty()) found.why = error.what();
    }
  return found;
}

int repair_result(const RepairOptions& options) {
  make_folder_for(options.out);
  results::repair(options.result, options.out);
  const Readable found = readable_frames(results::ResultsReader(options.out));
  if (!found.why.empty())
    throw results::ResultsError(
        fmt::format("{}; of {} frames in this copy {} can be read", found.why, found.written, found.count));
  fmt::print("{}: {} frames\n", options.out, found.count);
  return ended_well;
}

}  // namespace

void add_repair(CLI::App& app, int& code) {
  auto o = std::make_shared<RepairOptions>();
  CLI::App* verb = app.add_subcommand("repair", "Copy the data of a killed run to a clean results file");
  verb->add_option("result", o->result, "results file, finished or not")->required()->type_name("RESULT");
  verb->add_option("-o,--output", o->out, "the copy")->required()->type_name("FILE");
  verb->callback([o, &code] { code = repair_result(*o); });
}

}  // namespace trilith::program
