#include "coupling/assessments/calibrate/model/outline.hpp"

#include <algorithm>
#include <cmath>

#include "coupling/inputs/observed/distribution.hpp"

namespace coupling::calibrate {
namespace {

/// An outline is one figure: on wide cells too many would be the same.
constexpr double cells_of_reach_m = 1.0;

}  // namespace

Outline::Outline(const Site& site, const CalibrateSettings& settings)
    : polygons{site.observed_events.outline},
      sources{site, {}, cells_of_reach_m},
      share_within{settings.outline_percent / 100.0},
      blocks{static_cast<std::size_t>(settings.outline_blocks)} {
    move_to_terrain(polygons, site);
    const double step_m = sources.cell_m();
    for (const config::Shape& polygon : polygons) {
        for (const std::vector<config::Point2>& ring : polygon.parts) {
            for (std::size_t i = 1; i < ring.size(); ++i) {
                const Eigen::Vector2d from{ring[i - 1].x_m, ring[i - 1].y_m};
                const Eigen::Vector2d to{ring[i].x_m, ring[i].y_m};
                const auto steps = static_cast<int>(std::ceil((to - from).norm() / step_m));
                for (int k = 0; k <= steps; ++k) {
                    const double share = steps > 0 ? static_cast<double>(k) / steps : 0.0;
                    reach_m = std::max(reach_m, sources.at(from + share * (to - from)));
                }
            }
        }
    }
}

bool Outline::holds(const Eigen::Vector2d& place_m) const {
    return lies_within(polygons, place_m);
}

std::vector<double> Outline::reaches_around(std::span<const double> distances_m) const {
    const std::size_t surveys = std::max<std::size_t>(1, distances_m.size() / blocks);
    const double below = 1.0 - 0.5 * (1.0 - share_within);
    std::vector<double> reaches;
    for (std::size_t survey = 0; survey < surveys && !distances_m.empty(); ++survey) {
        std::vector<double> of_survey;
        for (std::size_t i = survey; i < distances_m.size() && of_survey.size() < blocks; i += surveys) {
            of_survey.push_back(distances_m[i]);
        }
        reaches.push_back(observed::Distribution{std::move(of_survey)}.quantile(below));
    }
    return reaches;
}

bool lies_within(std::span<const config::Shape> polygons, const Eigen::Vector2d& place_m) {
    return std::any_of(polygons.begin(), polygons.end(), [&](const config::Shape& polygon) {
        return config::point_in_polygon(polygon, {place_m.x(), place_m.y()});
    });
}

void move_to_terrain(std::vector<config::Shape>& polygons, const Site& site) {
    for (config::Shape& polygon : polygons) {
        for (std::vector<config::Point2>& ring : polygon.parts) {
            for (config::Point2& corner : ring) {
                corner.x_m -= site.origin_m().x();
                corner.y_m -= site.origin_m().y();
            }
        }
    }
}

}  // namespace coupling::calibrate
