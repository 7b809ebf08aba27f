#include "coupling/assessments/calibrate/sites/site_case.hpp"

#include <algorithm>
#include <utility>

#include "coupling/inputs/parameters/parameter_knowledge.hpp"
#include "coupling/inputs/site_draws.hpp"

namespace coupling::calibrate {
namespace {

/// Mean of the places from which rocks of an observation start.
Eigen::Vector2d mean_source(const Site& site, const Observation& observation) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double rocks = 0.0;
    for (const rockfall::ReleaseSource& source : site.sources) {
        if (observation.zones.empty() ||
            std::binary_search(observation.zones.begin(), observation.zones.end(), source.zone)) {
            sum += 0.5 * source.rocks * (source.first_m + source.last_m);
            rocks += source.rocks;
        }
    }
    return rocks > 0.0 ? Eigen::Vector2d{sum / rocks} : sum;
}

/// From the mean source to the mean of what was observed.
SightLine line_of(const Site& site, const Observation& observation) {
    SightLine line;
    if (!observation.is_plane()) {
        return line;
    }
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Sample* sample : {&observation.fit, &observation.held_out}) {
        for (const Eigen::Vector2d& point : sample->points) {
            mean += point;
        }
    }
    mean /= static_cast<double>(observation.fit.size() + observation.held_out.size());
    line.from_m = mean_source(site, observation);
    const Eigen::Vector2d along = mean - line.from_m;
    line.along = along.norm() > 0.0 ? Eigen::Vector2d{along.normalized()} : Eigen::Vector2d{1.0, 0.0};
    return line;
}

std::vector<SightLine> lines_of(const Site& site, const std::vector<Observation>& observations) {
    std::vector<SightLine> lines;
    for (const Observation& observation : observations) {
        lines.push_back(line_of(site, observation));
    }
    return lines;
}

}  // namespace

SiteCase::SiteCase(std::string of_site, const Scenario& its_scenario, const Site& its_site,
                   const CalibrateSettings& settings, std::uint64_t of_its_rocks)
    : name{std::move(of_site)},
      scenario{its_scenario},
      site{its_site},
      seed{of_its_rocks},
      falls{its_scenario, its_site, config::GridFrame{}},
      drawn{drawn_site(its_site)},
      components{components_on(*its_site.knowledge, drawn)},
      observations{observations_on(its_site, settings, of_its_rocks, its_scenario.file.string())},
      lines{lines_of(its_site, observations)},
      search{search_on(its_site, settings)} {}

rockfall::FallDraw SiteCase::draw_of(std::vector<double> factors) const {
    return draw_of_sets(*site.knowledge, drawn, scenario.rockfall.fall, {std::move(factors)}).falls.front();
}

}  // namespace coupling::calibrate
