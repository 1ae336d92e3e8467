// Whether a law's own equations act in a geometry, for who builds models.
#pragma once

#include <span>
#include <string>

#include "law/contact/list.hpp"

namespace trilith {

/// Empty where all of the law's equations act in each of these geometries; else which of them one leaves out, in which
/// geometries they act, and a remedy.
std::string form_refusal(const ContactLaw& law, std::span<const ContactForm> forms);

}  // namespace trilith
