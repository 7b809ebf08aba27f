#include "forest/protection/target_profile.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace forest {

namespace {

constexpr std::string_view source =
    "Frehner et al. 2005, NaiS, rockfall, transit zone [lit*]: as quoted, not held against the original";

constexpr std::array<TargetProfile, 3> profiles{{
    {0.4, 12.0, 400.0, 600.0, 20.0, source},
    {0.6, 24.0, 300.0, 400.0, 20.0, source},
    {1.8, 36.0, 150.0, 200.0, 20.0, source},
}};

/// Limits fall on borders of diameter classes.
double stems_from(const StandFigures& stand, double dbh_cm) {
    const auto first = static_cast<std::ptrdiff_t>(dbh_class_of(dbh_cm));
    return std::accumulate(stand.stems_pha_by_class.begin() + first, stand.stems_pha_by_class.end(), 0.0);
}

}  // namespace

std::span<const TargetProfile> target_profiles() {
    return profiles;
}

std::optional<TargetProfile> target_profile(double block_diameter_m) {
    const auto* found = std::find_if(profiles.begin(), profiles.end(), [&](const TargetProfile& profile) {
        return block_diameter_m <= profile.block_to_m;
    });
    return found == profiles.end() ? std::nullopt : std::optional{*found};
}

ProfileCheck check(const TargetProfile& profile, const StandFigures& stand, const GapFigures& gaps) {
    const double stems_pha = stems_from(stand, profile.dbh_from_cm);
    return {.stems_pha = stems_pha,
            .gap_m = gaps.max_m,
            .has_stems = stems_pha >= profile.least_stems_pha,
            .has_ideal_stems = stems_pha >= profile.ideal_stems_pha,
            .has_short_gaps = gaps.max_m <= profile.longest_gap_m};
}

}  // namespace forest
