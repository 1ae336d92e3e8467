#include "law/contact/form_check.hpp"

#include <fmt/format.h>

namespace trilith {
namespace {

/// "a, b" of the names for which a condition holds; "none" if there is none.
template <class Names, class Holds>
std::string listed(const Names& names, Holds&& holds) {
  std::string list;
  for (const auto& [key, name] : names)
    if (holds(key)) list += (list.empty() ? "" : ", ") + std::string(name);
  return list.empty() ? "none" : list;
}

template <class K>
std::string forms_of() {
  std::vector<std::pair<ContactForm, std::string_view>> names;
  for (const ContactForm form : contact_forms) names.emplace_back(form, contact_form_names[static_cast<int>(form)]);
  return listed(names, [](ContactForm form) { return left_out<K>(form).empty(); });
}

/// Laws with all equations acting in a geometry.
std::string laws_of(ContactForm form) {
  std::vector<std::pair<bool, std::string_view>> names;
  ContactLaws::for_each([&]<class L>() { names.emplace_back(left_out<typename L::Kernel>(form).empty(), L::name); });
  return listed(names, [](bool acts) { return acts; });
}

}  // namespace

std::string form_refusal(const ContactLaw& law, std::span<const ContactForm> forms) {
  return std::visit(
      [&]<class L>(const L&) -> std::string {
        for (const ContactForm form : forms)
          if (const std::string_view own = left_out<typename L::Kernel>(form); !own.empty())
            return fmt::format(
                "{} would ignore its own `{}`, which acts in these geometries: {}; use a law that acts in {} ({}), "
                "or write this law with `effective` and `friction` (law/contact/point_law.hpp), which act everywhere",
                contact_form_names[static_cast<std::size_t>(form)], own, forms_of<typename L::Kernel>(),
                contact_form_names[static_cast<std::size_t>(form)], laws_of(form));
        return "";
      },
      law);
}

}  // namespace trilith
