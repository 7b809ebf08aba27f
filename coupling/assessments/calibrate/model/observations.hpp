#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "coupling/assessments/calibrate/model/outline.hpp"
#include "coupling/assessments/calibrate/model/sample.hpp"
#include "coupling/assessments/calibrate/model/set_falls.hpp"
#include "coupling/assessments/calibrate/model/source_distance.hpp"
#include "coupling/assessments/calibrate/model/surveyed_trees.hpp"
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
    passing,
    tree_dbh,       ///< of hit stems among those that were searched, once for each hit
    tree_places,    ///< the same: where they stand
    tree_scars,     ///< wounds of each searched stem
    outline_share,  ///< whether a stop lies within the outline
    outline_reach,  ///< how far the outline reaches from the sources
    jumps           ///< lengths of jumps between impacts of one rock
};

/// Something that was observed, and what of a simulated set is held against it.
struct Observation {
    Seen seen = Seen::stops;
    std::string name;                                 ///< for tables: "stops", "stops:1", "speed:road"
    std::vector<std::uint32_t> zones{};               ///< from which its rocks came; none: any
    std::uint32_t site = 0;                           ///< place among the sites that are fitted to
    std::uint32_t target = 0;                         ///< of passages
    std::uint32_t witness = 0;                        ///< the same where the same rocks or scars are seen
    std::shared_ptr<const SourceDistance> sources{};  ///< of run-outs whose release is not known
    std::shared_ptr<const SurveyedTrees> trees{};     ///< that were searched for wounds
    std::uint64_t rocks = 0;                          ///< that gave them those wounds
    std::shared_ptr<const Outline> outline{};         ///< around stops
    std::vector<int> grounds{};                       ///< on which jumps begin; none: any
    double least_jump_m = 0.0;                        ///< shorter ones were not seen
    Sample fit{};                                     ///< fitted to
    Sample held_out{};                                ///< kept for the judgement

    [[nodiscard]] bool is_plane() const {
        return seen == Seen::stops || seen == Seen::scar_places || seen == Seen::tree_places;
    }
    /// Of its scale: what one stop or wound more makes, where counts of the model hardly scatter, and a cell
    /// of a reach. 0: nothing.
    [[nodiscard]] double least_scale() const;
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
/// the seed. Throws InputError (data) where nothing, or too little, was observed; `scenario`: the file that
/// messages name.
std::vector<Observation> observations_on(const Site& site, const CalibrateSettings& settings,
                                         std::uint64_t seed, const std::string& scenario = "[observed]");

/// How many stops, scars and passages the observations hold on one side: each counts once, whatever of it is
/// compared.
std::size_t number_of(const std::vector<Observation>& observations, Sample Observation::*side);

/// How the observations of a site came about.
Search search_on(const Site& site, const CalibrateSettings& settings);

/// Whether stops were looked for at a place.
bool is_looked_at(const Eigen::Vector2d& place_m, const Search& search);

/// Whether numbers of wounds are compared: the rocks that gave them are known, and not more than fall.
bool can_count_scars(const Site& site, const CalibrateSettings& settings);

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
