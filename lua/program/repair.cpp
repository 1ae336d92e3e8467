// trilith repair RESULT -o FILE
#include <fmt/format.h>

#include <memory>

#include "output_folder.hpp"
#include "results/reader.hpp"
#include "verbs.hpp"

namespace trilith::program {
namespace {

struct RepairOptions {
  std::string result, out;
};

int repair_result(const RepairOptions& options) {
  make_folder_for(options.out);
  results::repair(options.result, options.out);
  fmt::print("{}: {} frames\n", options.out, results::ResultsReader(options.out).frame_count());
  return ended_well;
}

}  // namespace

void add_repair(CLI::App& app, int& code) {
  auto o = std::make_shared<RepairOptions>();
  CLI::App* verb = app.add_subcommand("repair", "Copy what a killed run had written to a clean results file");
  verb->add_option("result", o->result, "results file, finished or not")->required()->type_name("RESULT");
  verb->add_option("-o,--output", o->out, "the copy")->required()->type_name("FILE");
  verb->callback([o, &code] { code = repair_result(*o); });
}

}  // namespace trilith::program
