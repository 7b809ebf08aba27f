#pragma once

#include <string>

namespace coupling {

/// A file for run.parameters: the shipped widths, and more on ground types that were guessed.
std::string text_of_guessed_widths();

}  // namespace coupling
