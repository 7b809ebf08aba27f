#pragma once

namespace coupling {

/// What a new project says of nets and their design, commented out. The factors are those that are refused
/// as adding nothing until a guideline's stand there.
inline constexpr const char* nets_commented_out =
    ";keep_paths = yes           ; then `bannwald net place out --nets LINES` finds where nets are needed\n"
    "\n[design]\n"
    ";rule = own                 ; a net to order: with the factors of your guideline\n"
    ";percentile = 95\n"
    ";energy_factor = 1.0\n"
    ";height_factor = 1.0\n"
    ";freeboard_m = 0.0\n";

}  // namespace coupling
