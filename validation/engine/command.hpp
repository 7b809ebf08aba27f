#pragma once

#include "coupling/program/line/command.hpp"

namespace coupling::validation {

/// `bannwald validate`.
Command validate_command();

}  // namespace coupling::validation
