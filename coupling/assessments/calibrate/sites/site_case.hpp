#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "coupling/assessments/calibrate/model/observations.hpp"
#include "coupling/inputs/parameters/parameter_draws.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/inputs/site_falls.hpp"

namespace coupling::calibrate {

/// A site of a calibration: what falls there, what was seen there. It keeps references to scenario and site
/// and does not move.
struct SiteCase {
    /// `settings`: of this site, with what the search has for all sites. `seed`: of its rocks and of what is
    /// held out. Throws InputError.
    SiteCase(std::string name, const Scenario& scenario, const Site& site, const CalibrateSettings& settings,
             std::uint64_t seed);

    const std::string name;  ///< on pages, in tables and in names of files
    const Scenario& scenario;
    const Site& site;
    const std::uint64_t seed;
    const SiteFalls falls;
    const DrawnSite drawn;
    const std::vector<ParameterDraws::Component> components;  ///< of the site alone
    const std::vector<Observation> observations;
    const std::vector<SightLine> lines;  ///< by observation
    const Search search;

    /// Laws of a parameter set, from factors of the components in their order.
    [[nodiscard]] rockfall::FallDraw draw_of(std::vector<double> factors) const;
};

}  // namespace coupling::calibrate
