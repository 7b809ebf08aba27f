#pragma once

#include <string>

#include "config/errors/warnings.hpp"
#include "coupling/assessments/profile/falls/profile_tally.hpp"
#include "coupling/results/figures/json.hpp"
#include "rockfall/motion/seam/fall_figures.hpp"

namespace coupling::profile {

/// "8.3 % of the rocks leave the profile (lower end: 8.3 %)" or that none does, for the screen.
std::string departures_in_words(const ProfileTally& tally);

/// The same ends and shares in the language of the page; empty where no rock leaves.
std::string ends_on_page(const ProfileTally& tally);

/// Share of the rocks that leave, and the ends over which they do.
Json json_departures(const ProfileTally& tally);

/// What the motion model may be doubted for.
rockfall::FallFigures fall_figures_of(const ProfileTally& tally);

/// From departures_to_warn_of on.
void warn_of_departures(const ProfileTally& tally, config::Warnings& warnings);

}  // namespace coupling::profile
