#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "forest/inventory/tables.hpp"
#include "forest/protection/gaps.hpp"

namespace forest {

/// What a stand in the transit zone needs against blocks of a size, after the Swiss guideline NaiS.
struct TargetProfile {
    double block_to_m = 0.0;   ///< largest block it is meant for, diameter
    double dbh_from_cm = 0.0;  ///< stems from here on count
    double least_stems_pha = 0.0;
    double ideal_stems_pha = 0.0;
    double longest_gap_m = 0.0;  ///< along the fall line; longer ones want logs and high stumps
    std::string_view source;
};

/// All classes of block size, rising.
std::span<const TargetProfile> target_profiles();

/// The profile for blocks of a diameter. Nothing above the largest class, where NaiS asks for no stand.
std::optional<TargetProfile> target_profile(double block_diameter_m);

/// A stand held against a profile.
struct ProfileCheck {
    double stems_pha = 0.0;  ///< that count
    double gap_m = 0.0;      ///< the longest one
    bool has_stems = false;
    bool has_ideal_stems = false;
    bool has_short_gaps = false;
    [[nodiscard]] bool met() const { return has_stems && has_short_gaps; }
};
ProfileCheck check(const TargetProfile& profile, const StandFigures& stand, const GapFigures& gaps);

}  // namespace forest
