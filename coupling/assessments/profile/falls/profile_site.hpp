#pragma once

#include <memory>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "config/table/declared.hpp"
#include "coupling/inputs/site.hpp"
#include "rockfall/slope/profile_strip.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::profile {

/// A place along the profile at which passing rocks are counted.
struct Station {
    std::string name;
    double distance_m;  ///< in plan, as the profile counts it
};

const config::Schema<rockfall::ProfilePoint>& corner_columns();
const config::Schema<Station>& station_columns();

/// A profile with everything on it, read, checked and valid.
struct ProfileSite {
    std::vector<rockfall::ProfilePoint> corners;          ///< as the file has them
    rockfall::Slope slope;                                ///< the ground that rocks feel, as a strip
    double start_m = 0.0;                                 ///< distance of the release
    std::vector<Station> stations;                        ///< downhill
    std::shared_ptr<const ParameterKnowledge> knowledge;  ///< of the laws of the fall
    std::vector<InputFile> inputs;

    [[nodiscard]] double first_m() const { return corners.front().distance_m; }
    [[nodiscard]] double last_m() const { return corners.back().distance_m; }
    /// Height of the profile as read; beyond an end that of the end.
    [[nodiscard]] double height_m(double distance_m) const;
    /// Length along the profile as read, from its upper end; beyond an end that of the end.
    [[nodiscard]] double slope_length_m(double distance_m) const;
    /// The distance that lies so far along the slope.
    [[nodiscard]] double distance_at_m(double slope_length_m) const;
};

/// Opens, reads and checks the files of a scenario with terrain.profile. Throws InputError with all problems
/// that can be found at once; what is only doubtful becomes a warning.
ProfileSite open_profile(const Scenario& scenario, config::Warnings& warnings);

}  // namespace coupling::profile
