// Methods of sections of fibres: section:moment_curvature, section:interaction, section:plot.
#pragma once

#include <span>

#include "bindings/core/bindings.hpp"

namespace trilith::script {

/// The methods of Kind<SectionValue>.
std::span<const Method> section_methods();

}  // namespace trilith::script
