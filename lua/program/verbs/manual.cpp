// trilith manual [NAME]
#include <fmt/format.h>

#include <memory>

#include "base/whole_file.hpp"
#include "console/console_session.hpp"
#include "program/man_page.hpp"
#include "program/script/state.hpp"
#include "program/verbs.hpp"

namespace trilith::program {
namespace {

struct ManualOptions {
  std::string name, meta;
  bool check = false, markdown = false, pages = false, man = false;
};

std::string what_of(const ManualOptions& options) {
  if (options.check) return "check";
  if (options.markdown) return "markdown";
  if (options.pages) return "pages";
  return options.meta.empty() ? "" : "meta";
}

int show_manual(const ManualOptions& options) {
  script::Host host;
  const ScriptState state = new_script_state(host);
  ConsoleSession session(state.get(), host);
  const std::string what = what_of(options);
  std::string text;
  const bool good = session.manual(state.get(), what, options.name, text);
  if (!good) {
    fmt::print(stderr, "{}\n", text);
    return wrong_input;
  }
  if (options.meta.empty() || options.meta == "-")
    fmt::print("{}", text);
  else
    write_whole_file(options.meta, text);
  return ended_well;
}

}  // namespace

void add_manual(CLI::App& app, int& code) {
  auto options = std::make_shared<ManualOptions>();
  CLI::App* verb =
      app.add_subcommand("manual", "Print the manual of the Lua interface, the same text as help at the console");
  verb->add_option("name", options->name, "a function, a field or a page; without it, the list of pages")
      ->type_name("NAME");
  verb->add_option("--meta", options->meta,
                   "write the declarations for editors to FILE (- for here); see docs/editor.md")
      ->type_name("FILE");
  verb->add_flag("--markdown", options->markdown, "the page NAME as Markdown; without NAME, the list of pages");
  verb->add_flag("--pages", options->pages, "the names of the pages, one per line");
  verb->add_flag("--check", options->check, "print parts of the interface that are not declared");
  verb->add_flag("--man", options->man, "the commands and options of this program, as a man page");
  verb->callback([&app, options, &code] {
    if (options->man)
      fmt::print("{}", man_page(app));
    else
      code = show_manual(*options);
  });
}

}  // namespace trilith::program
