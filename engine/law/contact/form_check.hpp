// Checks whether a law's own equations act in a geometry, for model builders.
#pragma once

#include <span>
#include <string>

#include "law/contact/list.hpp"

namespace trilith {

/// Empty where all equations of the law act in each of these geometries. Otherwise a text: the geometries that lack
/// some of them, the geometries in which they act, and a remedy.
std::string form_refusal(const ContactLaw& law, std::span<const ContactForm> forms);

}  // namespace trilith
