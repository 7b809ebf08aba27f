#pragma once

namespace coupling::validation {

/// Thrown where the user wants no more (InterruptGuard).
struct Interrupted {};

}  // namespace coupling::validation
