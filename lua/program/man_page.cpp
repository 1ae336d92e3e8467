#include "man_page.hpp"

#include <fmt/format.h>

#include "command_line.hpp"

namespace trilith::program {
namespace {

/// Text for roff: no line of it is a request, and a typed hyphen remains the ASCII one.
std::string roff(const std::string& text) {
  std::string out;
  for (const char c : text) {
    const bool begins_line = out.empty() || out.back() == '\n';
    if (begins_line && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\')
      out += "\\e";
    else if (c == '-')
      out += "\\-";
    else
      out += c;
  }
  return out;
}

std::string bold(const std::string& text) {
  return "\\fB" + roff(text) + "\\fR";
}
std::string slanted(const std::string& text) {
  return "\\fI" + roff(text) + "\\fR";
}

/// "RESULT", "[NAME=VALUE ...]"
std::string place_text(const CLI::Option& o) {
  const bool many = o.get_items_expected_max() > 1;
  const std::string word = slanted(value_word(o)) + (many ? " ..." : "");
  return o.get_required() ? word : "[" + word + "]";
}

std::string entry(const std::string& head, const CLI::Option& o) {
  const bool said = o.get_default_str().empty();
  const std::string otherwise = said ? "" : fmt::format(" (default {})", roff(o.get_default_str()));
  return fmt::format(".TP\n{}\n{}{}\n", head, roff(o.get_description()), otherwise);
}

std::string named_entry(const CLI::Option& o) {
  std::string head;
  for (const std::string& name : spellings(o)) head += (head.empty() ? "" : ", ") + bold(name);
  const std::vector<std::string> values = listed_values(o);
  const std::string word = values.empty() ? value_word(o) : CLI::detail::join(values, "|");
  return entry(word.empty() ? head : head + " " + slanted(word), o);
}

std::string verb_section(const std::string& program, const CLI::App& verb) {
  std::string usage = bold(program + " " + verb.get_name());
  if (!named_options(verb).empty()) usage += " [" + slanted("options") + "]";
  for (const CLI::Option* o : placed_options(verb)) usage += " " + place_text(*o);
  std::string text = fmt::format(".SS {}\n{}\n.PP\n{}.\n", roff(verb.get_name()), usage, roff(verb.get_description()));
  for (const CLI::Option* o : placed_options(verb)) text += entry(slanted(value_word(*o)), *o);
  for (const CLI::Option* o : named_options(verb)) text += named_entry(*o);
  return text;
}

}  // namespace

std::string man_page(const CLI::App& app) {
  const std::string& name = app.get_name();
  std::string text = fmt::format(".TH TRILITH 1 \"\" \"Trilith {}\" \"User Commands\"\n.SH NAME\n{} \\- {}\n",
                                 TRILITH_VERSION, roff(name), roff(app.get_description()));
  text += fmt::format(".SH SYNOPSIS\n.nf\n{0}\n{0} {1} [{2} ...]\n{0} {3} [{4}] ...\n.fi\n", bold(name),
                      slanted("SCRIPT"), slanted("NAME=VALUE"), slanted("VERB"), slanted("options"));
  text += ".SH DESCRIPTION\n.nf\n" + roff(app.get_footer()) + "\n.fi\n.SH OPTIONS\n";
  text += entry(bold("-h") + ", " + bold("--help"), *app.get_help_ptr());
  for (const CLI::Option* o : named_options(app)) text += named_entry(*o);
  text += ".SH VERBS\n";
  for (const CLI::App* verb : listed_verbs(app)) text += verb_section(name, *verb);
  return text;
}

}  // namespace trilith::program
