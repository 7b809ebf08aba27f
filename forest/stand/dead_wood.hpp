#pragma once

#include <cstdint>
#include <vector>

#include "forest/stand/tree.hpp"
#include "forest/stand/volume_loss.hpp"

namespace forest {

/// A dead tree or what is left of it, still upright: a snag, a broken stem, a stump.
struct Snag {
    TreeId tree{};  ///< the tree it was
    double x_m = 0.0;
    double y_m = 0.0;
    SpeciesId species{};
    bool cut = false;            ///< a stump of felling
    double dbh_cm = 0.0;         ///< at 1.3 m when it died
    double tree_height_m = 0.0;  ///< when it died
    double height_m = 0.0;       ///< of what stands; below tree_height_m = broken off
    std::int32_t year = 0;       ///< of death
    double density_share = 1.0;  ///< (0, 1], wood density relative to sound wood
    double sound_kg = 0.0;       ///< dry mass of what stands, as it was when the tree died
};

/// Why a log lies there.
enum class LogOrigin : std::uint8_t { fallen, windthrow, felled_crosswise, broken_by_rock };

/// A lying stem or piece of one, straight from the thick to the thin end.
struct Log {
    TreeId tree{};
    double x_m = 0.0;  ///< thick end
    double y_m = 0.0;
    double direction_rad = 0.0;  ///< from the thick to the thin end, counter-clockwise from east, on the map
    double length_m = 0.0;       ///< along the log
    double thick_end_cm = 0.0;
    double thin_end_cm = 0.0;
    double clearance_m = 0.0;    ///< between ground and underside
    double density_share = 1.0;  ///< (0, 1]
    SpeciesId species{};
    LogOrigin origin = LogOrigin::fallen;
    bool anchored = false;  ///< behind stumps or by cables
    std::int32_t year = 0;  ///< since when it lies
    double sound_kg = 0.0;  ///< dry mass of the piece, as it was when the tree died
};

/// Dry mass [kg] that decay has left: of density and of volume. A stem keeps its mass when it dies, falls or
/// breaks.
constexpr double mass_kg(const Snag& snag) {
    return snag.density_share * volume_left(snag.density_share) * snag.sound_kg;
}
constexpr double mass_kg(const Log& log) {
    return log.density_share * volume_left(log.density_share) * log.sound_kg;
}

/// Diameters of a piece relative to those of the tree that died [-]: it shrinks in thickness, not in length
/// [choice].
double diameter_left(const Snag& snag);
double diameter_left(const Log& log);

/// All dead wood of a stand, oldest first.
struct SnagsAndLogs {
    std::vector<Snag> snags;
    std::vector<Log> logs;
};

}  // namespace forest
