#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "coupling/assessments/calibrate/model/sample.hpp"
#include "coupling/assessments/calibrate/model/set_falls.hpp"
#include "coupling/assessments/calibrate/model/source_distance.hpp"
#include "coupling/inputs/scenario/calibrate_settings.hpp"
#include "coupling/inputs/site.hpp"

namespace coupling::calibrate {

/// What was seen.
enum class Seen : std::uint8_t {
    stops,    ///< places
    run_out,  ///< of stops: from the release where that is known, else from the nearest source
    scar_heights,
    scar_places,
    speed,
    height,
    energy,
    translation,
    passing
};

/// Something that was observed, and what of a simulated set is held against it.
struct Observation {
    Seen seen = Seen::stops;
    std::string name;                                 ///< for tables: "stops", "stops:1", "speed:road"
    std::vector<std::uint32_t> zones{};               ///< from which its rocks came; none: any
    std::uint32_t target = 0;                         ///< of passages
    std::uint32_t witness = 0;                        ///< the same where the same rocks or scars are seen
    std::shared_ptr<const SourceDistance> sources{};  ///< of run-outs whose release is not known
    Sample fit{};                                     ///< fitted to
    Sample held_out{};                                ///< kept for the judgement

    [[nodiscard]] bool is_plane() const { return seen == Seen::stops || seen == Seen::scar_places; }
};

/// How observations came about, so that the same is done to simulated rocks.
struct Search {
    std::vector<config::Shape> window{};  ///< polygons in coordinates of the terrain; none: everywhere
    double least_diameter_m = 0.0;
    double least_scar_dbh_cm = 0.0;
};

/// All observations of a site, parted into those that are fitted to and those that are held out.
///
/// Stops of groups whose rocks came from release zones of their own are observations of their own. Held out
/// is a group, or a share: whole groups where there are five of a kind or more, else single ones, drawn by
/// the seed. Throws InputError (data) where nothing, or too little, was observed.
std::vector<Observation> observations_on(const Site& site, const CalibrateSettings& settings,
                                         std::uint64_t seed);

/// How many stops, scars and passages the observations hold on one side: each counts once, whatever of it is
/// compared.
std::size_t number_of(const std::vector<Observation>& observations, Sample Observation::*side);

/// How the observations of a site came about.
Search search_on(const Site& site, const CalibrateSettings& settings);

/// What of the rocks of a set could have been seen as `observation`.
Sample seen_of(const SetRocks& rocks, const Observation& observation, const Search& search);

/// A figure of a sample for tables and pages: of values their mean, of places the mean distance along an
/// axis.
struct SightLine {
    Eigen::Vector2d from_m = Eigen::Vector2d::Zero();
    Eigen::Vector2d along{1.0, 0.0};
};
double figure_of(const Sample& sample, const SightLine& line);
/// Values, or distances of places along the line, sorted.
std::vector<double> values_along(const Sample& sample, const SightLine& line);

}  // namespace coupling::calibrate
