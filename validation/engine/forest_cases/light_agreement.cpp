#include "validation/engine/forest_cases/light_agreement.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "forest/light/light.hpp"

namespace coupling::validation::forest_cases {
namespace {

using config::joined;
using forest::Canopy;
using forest::compute_light;
using forest::Direction;
using forest::Edges;
using forest::Exposure;
using forest::ground_normal;
using forest::Horizon;
using forest::LightField;
using forest::LightGround;
using forest::LightSite;
using forest::LightTree;
using forest::LightYear;
using forest::Sky;
using forest::SkySettings;
using forest::slope_radiation;
using forest::SlopeRadiation;
using forest::turn_of;

/// A plane that rises along the y axis, repeating itself.
LightGround plane_of(const MappedStand& stand, const MappedSlope& slope, double column_m) {
    const auto cells = static_cast<int>(std::lround(stand.side_m / column_m));
    LightGround ground;
    ground.elevation_m = config::Raster<double>{{cells, cells, 0.0, 0.0, column_m, column_m}};
    ground.edges = Edges::torus;
    const Direction normal = ground_normal(
        slope.slope,
        config::Angle::from_degrees(slope.aspect.in_degrees() - slope.y_axis_azimuth.in_degrees()));
    ground.gain_x_m = -normal.x / normal.z * stand.side_m;
    ground.gain_y_m = -normal.y / normal.z * stand.side_m;
    const config::GridFrame& frame = ground.elevation_m.frame;
    for (std::size_t cell = 0; cell < frame.size(); ++cell) {
        const config::Cell at = frame.cell_of(cell);
        ground.elevation_m.values[cell] =
            (ground.gain_x_m * frame.x_centre_m(at.column) + ground.gain_y_m * frame.y_centre_m(at.row)) /
            stand.side_m;
    }
    return ground;
}

Sky sky_of(const MappedStand& stand, const MappedSlope& slope) {
    SkySettings settings;
    settings.latitude = stand.latitude;
    settings.y_axis_azimuth = slope.y_axis_azimuth;
    settings.lowest_sun = {};
    settings.beam_transmission = 1.0;
    return {settings, stand.radiation};
}

template <class Values>
double mean_value(const Values& values) {
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    return sum / static_cast<double>(values.size());
}

double sum_of_months(const std::array<double, 12>& months) {
    return std::accumulate(months.begin(), months.end(), 0.0);
}

/// Means and spread of two lists of the same places.
struct PlaceAgreement {
    double correlation = 0.0;  ///< NaN of fewer than three places, or where one of the lists is even
    double bias = 0.0;
    double rmse = 0.0;
};

bool is_even(const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [&](double value) { return value == values.front(); });
}

PlaceAgreement agreement_of(const std::vector<double>& ours, const std::vector<double>& reference) {
    assert(ours.size() == reference.size() && !ours.empty());
    const double our_mean = mean_value(ours);
    const double their_mean = mean_value(reference);
    double both = 0.0;
    double our_spread = 0.0;
    double their_spread = 0.0;
    double squares = 0.0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        const double a = ours[i] - our_mean;
        const double b = reference[i] - their_mean;
        both += a * b;
        our_spread += a * a;
        their_spread += b * b;
        squares += (ours[i] - reference[i]) * (ours[i] - reference[i]);
    }
    const double spread = std::sqrt(our_spread * their_spread);
    // Rounding gives an even list a spread a little above 0.
    const bool is_known =
        ours.size() >= least_places_of_correlation && !is_even(ours) && !is_even(reference) && spread > 0.0;
    return {.correlation = is_known ? both / spread : std::numeric_limits<double>::quiet_NaN(),
            .bias = our_mean - their_mean,
            .rmse = std::sqrt(squares / static_cast<double>(ours.size()))};
}

/// Ground light of the columns in which sensors stand.
std::vector<double> light_at(const std::vector<LightSensor>& sensors, const config::GridFrame& columns,
                             const std::vector<float>& ground_light) {
    std::vector<double> light;
    for (const LightSensor& sensor : sensors) {
        config::Cell cell = columns.cell_at(sensor.x_m, sensor.y_m);
        // A sensor on the outer edge belongs to the last column.
        cell.column = std::clamp(cell.column, 0, columns.columns - 1);
        cell.row = std::clamp(cell.row, 0, columns.rows - 1);
        light.push_back(ground_light[columns.index(cell)]);
    }
    return light;
}

}  // namespace

std::string why_no_correlation(const std::vector<double>& reference) {
    if (reference.size() < least_places_of_correlation) {
        return joined("a correlation needs ", std::to_string(least_places_of_correlation),
                      " places or more, and there ", reference.size() == 1 ? "is " : "are ",
                      std::to_string(reference.size()));
    }
    return is_even(reference) ? "the reference light is the same at all places" : "";
}

std::string why_no_correlation(const MappedStand& stand, const MappedSlope& slope, double column_m) {
    std::string reason = why_no_correlation(slope.sensor_light);
    if (!reason.empty()) {
        return reason;
    }
    const auto column_of_light = [&](const LightSensor& sensor) {
        const double last = std::round(stand.side_m / column_m) - 1.0;  // of a sensor on the outer edge
        return std::pair{std::min(last, std::floor(sensor.x_m / column_m)),
                         std::min(last, std::floor(sensor.y_m / column_m))};
    };
    const auto first = column_of_light(stand.sensors.front());
    return std::all_of(stand.sensors.begin(), stand.sensors.end(),
                       [&](const LightSensor& sensor) { return column_of_light(sensor) == first; })
               ? joined("all sensors stand in one column of light of ", config::to_text(column_m), " m")
               : "";
}

LightAgreement compare_light(const MappedStand& stand, const MappedSlope& slope,
                             const MappedSettings& settings) {
    const LightGround ground = plane_of(stand, slope, settings.column_m);
    const config::Angle facing =
        config::Angle::from_degrees(slope.aspect.in_degrees() - slope.y_axis_azimuth.in_degrees());
    const double least_cosine = turn_of(config::Angle::from_degrees(settings.months.least_angle_deg)).sin;
    const std::array<Exposure, 1> place{{{ground_normal(slope.slope, facing), Horizon{}, least_cosine}}};
    const LightSite site{sky_of(stand, slope), ground, place, {.ground_points = settings.ground_points}};
    std::vector<LightTree> trees = stand.trees;
    for (LightTree& tree : trees) {
        tree.extinction = settings.extinction;
    }
    LightYear year;
    year.radiation = stand.radiation;
    year.leaves_on.fill(true);
    for (int month = 1; month <= 12; ++month) {
        year.season[static_cast<std::size_t>(month - 1)] =
            month >= settings.months.first && month <= settings.months.last;
    }
    const LightField field = compute_light(site, Canopy{site.ground(), trees}, year, trees);
    const SlopeRadiation energy = slope_radiation(site.sky(), place[0], stand.radiation);

    LightAgreement agreement;
    if (slope.direct_mjpm2 > 0.0) {
        agreement.energy_direct_ratio = sum_of_months(energy.slope.direct_mjpm2) / slope.direct_mjpm2;
        agreement.energy_diffuse_ratio = sum_of_months(energy.slope.diffuse_mjpm2) / slope.diffuse_mjpm2;
    }
    agreement.ground_light = mean_value(field.ground_light);
    if (!slope.ground_light.empty()) {
        agreement.ground_light_difference = agreement.ground_light - mean_value(slope.ground_light);
    }
    agreement.tree_light.assign(field.light_ratio.begin(), field.light_ratio.end());
    if (!slope.tree_light.empty()) {
        const PlaceAgreement trees_agree = agreement_of(agreement.tree_light, slope.tree_light);
        agreement.tree_light_correlation = trees_agree.correlation;
        agreement.tree_light_bias = trees_agree.bias;
        agreement.tree_light_rmse = trees_agree.rmse;
    }
    if (!slope.sensor_light.empty()) {
        agreement.sensor_light = light_at(stand.sensors, ground.elevation_m.frame, field.ground_light);
        const PlaceAgreement sensors_agree = agreement_of(agreement.sensor_light, slope.sensor_light);
        agreement.sensor_correlation = sensors_agree.correlation;
        agreement.sensor_bias = sensors_agree.bias;
        agreement.sensor_rmse = sensors_agree.rmse;
    }
    return agreement;
}

}  // namespace coupling::validation::forest_cases
