#pragma once

#include <cstdint>
#include <string>

namespace coupling {

/// Whether a search rules out sets by emulators.
enum class Emulates : std::uint8_t {
    by_model,  ///< with motion models whose rocks have a shape of their own: they are slow
    yes,
    no
};

/// The settings of section [calibrate]: how parameters are fitted to what section [observed] names.
struct CalibrateSettings {
    std::uint64_t sets = 500;           ///< parameter sets of the sample that is kept
    std::uint64_t first_sets = 512;     ///< sets of the first wave, spread over what the widths allow
    std::uint64_t most_sets = 12'000;   ///< sets that are tried in all; the search ends there at the latest
    std::uint64_t rocks = 300;          ///< rocks of each set
    double hold_out_percent = 20.0;     ///< of what was observed: not fitted to, for the judgement
    std::string hold_out_group;         ///< this group instead; empty: a share of all
    std::string window;                 ///< polygons within which stops were looked for; empty: everywhere
    double least_diameter_m = 0.0;      ///< smaller rocks were not looked for
    double least_scar_dbh_cm = 0.0;     ///< on thinner stems scars were not looked for
    double outline_percent = 95.0;      ///< of the blocks lie within an outline
    std::uint64_t outline_blocks = 50;  ///< around so many it was drawn
    std::string sites;                  ///< scenarios of further sites, that share parameters with this one
    bool transfer = true;               ///< fits to all sites but one, too, to say how far that one is off
    Emulates emulator = Emulates::by_model;
    double least_jump_m = 0.0;  ///< shorter jumps are no two impacts; 0: the shortest that was seen
};

}  // namespace coupling
