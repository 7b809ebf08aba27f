#include "tests/benchmarks/light_ordinary.hpp"

#include <algorithm>
#include <cmath>

namespace benchmarks {
namespace {

constexpr double step_m = 1.0;

/// Energy of a zone in the season, at right angles.
double season_energy(const forest::LightSite& site, const forest::SkyView& view,
                     const forest::LightYear& year, std::size_t zone) {
    double energy = 0.0;
    for (std::size_t month = 0; month < 12; ++month) {
        energy += year.season[month] ? view.diffuse[zone] * year.radiation.diffuse_mjpm2[month] : 0.0;
    }
    for (std::size_t beam = site.first_beam(zone); beam < site.first_beam(zone + 1); ++beam) {
        const std::uint32_t month = site.sky().beams()[beam].month;
        energy += year.season[month] ? view.beam[beam] * year.radiation.direct_mjpm2[month] : 0.0;
    }
    return energy;
}

}  // namespace

LightMarch::LightMarch(const forest::LightGround& ground, const forest::Canopy& canopy,
                       const forest::PaddedGround& padded)
    : canopy_{canopy}, ground_m_{ground.elevation_m}, top_m_{canopy.top_m()} {
    for (std::size_t column = 0; column < ground_m_.frame.size(); ++column) {
        const float* nodes = canopy.leaf_on().of(padded.padded(column)) + forest::PrefixSums::nodes_below;
        for (std::size_t layer = 0; layer < forest::canopy_layers; ++layer) {
            extinction_per_m_.push_back((nodes[layer + 1] - nodes[layer]) / forest::layer_height_m);
        }
    }
}

double LightMarch::ground_at(double x_m, double y_m) const {
    const config::GridFrame& frame = ground_m_.frame;
    const double column = std::clamp(x_m / frame.cell_width_m - 0.5, 0.0, frame.columns - 1.0);
    const double row =
        std::clamp((frame.y_north_m() - y_m) / frame.cell_height_m - 0.5, 0.0, frame.rows - 1.0);
    const int west = std::min(static_cast<int>(column), frame.columns - 2);
    const int north = std::min(static_cast<int>(row), frame.rows - 2);
    const double to_east = column - west;
    const double to_south = row - north;
    return (1.0 - to_south) *
               ((1.0 - to_east) * ground_m_.at({west, north}) + to_east * ground_m_.at({west + 1, north})) +
           to_south * ((1.0 - to_east) * ground_m_.at({west, north + 1}) +
                       to_east * ground_m_.at({west + 1, north + 1}));
}

double LightMarch::transmittance(double x_m, double y_m, double z_m, const forest::Direction& towards) const {
    const config::GridFrame& frame = ground_m_.frame;
    double tau = 0.0;
    for (double gone_m = 0.5 * step_m; gone_m < 500.0; gone_m += step_m) {
        const double at_x_m = x_m + gone_m * towards.x;
        const double at_y_m = y_m + gone_m * towards.y;
        const config::Cell cell = frame.cell_at(at_x_m, at_y_m);
        if (!frame.contains(cell)) {
            break;
        }
        const double height_m = z_m + gone_m * towards.z - ground_at(at_x_m, at_y_m);
        if (height_m < 0.0) {
            return 0.0;
        }
        if (height_m > top_m_) {
            break;
        }
        const auto layer =
            std::min(static_cast<std::size_t>(height_m / forest::layer_height_m), forest::canopy_layers - 1);
        tau += step_m * extinction_per_m_[frame.index(cell) * forest::canopy_layers + layer];
        if (tau > 7.0) {
            return 0.0;
        }
    }
    return std::exp(-tau);
}

MarchedLight LightMarch::season(const forest::LightSite& site, const forest::LightYear& year) const {
    const config::GridFrame& frame = ground_m_.frame;
    MarchedLight sum;
    std::size_t used = 0;
    for (std::size_t column = 0; column < frame.size(); ++column) {
        const config::Cell cell = frame.cell_of(column);
        const double x_m = frame.x_centre_m(cell.column);
        const double y_m = frame.y_centre_m(cell.row);
        const double ground_m = ground_m_.at(cell);
        const forest::SkyView& view = site.view(column);
        double open = 0.0;
        double open_ground = 0.0;
        double cells = 0.0;
        double ground = 0.0;
        for (std::size_t zone = 0; zone < site.sky().zones().size(); ++zone) {
            const forest::Direction& towards = site.sky().zones()[zone];
            const double energy = season_energy(site, view, year, zone);
            if (energy == 0.0) {
                continue;
            }
            open += energy;
            open_ground += energy * view.on_ground[zone];
            ground += energy * view.on_ground[zone] * transmittance(x_m, y_m, ground_m, towards);
            for (std::size_t layer = 0; layer < canopy_.layers_used(column); ++layer) {
                const double height_m = (static_cast<double>(layer) + 0.5) * forest::layer_height_m;
                cells += energy * transmittance(x_m, y_m, ground_m + height_m, towards);
            }
        }
        sum.ground += ground / open_ground;
        sum.cells += cells / open;
        used += canopy_.layers_used(column);
    }
    const auto columns = static_cast<double>(frame.size());
    return {sum.ground / columns, sum.cells / static_cast<double>(used)};
}

double mean_transmittance(const forest::LightSite& site, const forest::Canopy& canopy,
                          const forest::LightField& field) {
    const std::size_t columns = site.ground().frame().size();
    double sum = 0.0;
    std::size_t used = 0;
    for (std::size_t column = 0; column < columns; ++column) {
        used += canopy.layers_used(column);
        for (std::size_t layer = 0; layer < canopy.layers_used(column); ++layer) {
            sum += static_cast<double>(field.cell(column, layer)[forest::LightField::season_value] /
                                       field.open_season[column]);
        }
    }
    return sum / static_cast<double>(used);
}

}  // namespace benchmarks
