#include "coupling/inputs/rockyfor3d/grounds.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "rockfall/laws/restitution.hpp"

namespace coupling::rockyfor3d {
namespace {

/// A soil type of Rockyfor3D v5.2: middle of its range of normal restitution, and our ground types of the
/// same origin.
struct SoilType {
    double r_n;
    const char* smooth;
    const char* rough;  ///< from `rough_from_m` mean obstacle height
};

/// Labels and numbers of Dorren (2016) as cited by others; the shipped types are a choice.
constexpr std::array soil_types{
    SoilType{0.0, "forest_soil_deep", "forest_soil_deep"},            // river, swamp: the rock sinks in
    SoilType{0.23, "forest_soil_deep", "forest_soil_coarse_debris"},  // fine soil, deep
    SoilType{0.28, "forest_soil_shallow",
             "forest_soil_coarse_debris"},                // fine soil, shallow; sand and gravel
    SoilType{0.33, "soil_with_debris", "coarse_debris"},  // scree below 10 cm, medium compact soil
    SoilType{0.38, "fine_debris", "coarse_debris"},       // talus above 10 cm
    SoilType{0.43, "weathered_rock", "weathered_rock"},   // bedrock under thin material
    SoilType{0.53, "solid_rock", "solid_rock"},           // bedrock
    SoilType{0.35, "road", "road"},                       // asphalt
};

/// Blocks of this mean height are coarse debris: those of the shipped types stand out by 0.36 m, fine ones by
/// 0.07 m.
constexpr double rough_from_m = 0.2;

/// Rockyfor3D writes this height where every rock stops.
constexpr double stops_all_m = 100.0;

double energy_share(double height_m, double rock_radius_m) {
    return std::clamp(1.0 / (1.0 + height_m / rock_radius_m), 0.1, 0.99);
}

double mean_roughness_m(const Ground& ground) {
    return 0.7 * ground.rg70_m + 0.2 * ground.rg20_m + 0.1 * ground.rg10_m;
}

/// Soil type and three heights in steps.
using Kind = std::array<long long, 4>;

/// Whole centimetres in metres, correctly rounded: 115 steps of 0.01 m would be 1.1500000000000001 m.
double metres(long long cm) {
    constexpr double cm_per_m = 100.0;
    return static_cast<double>(cm) / cm_per_m;
}

std::map<Kind, std::vector<std::size_t>> kinds_by(const Folder& folder, long long step_cm) {
    const auto steps = [&](double height_m) { return std::llround(height_m / metres(step_cm)); };
    std::map<Kind, std::vector<std::size_t>> kinds;
    for (std::size_t i = 0; i < folder.dem.values.size(); ++i) {
        if (!std::isnan(folder.dem.values[i])) {
            kinds[{std::llround(folder.soil_type.values[i]), steps(folder.rg70.values[i]),
                   steps(folder.rg20.values[i]), steps(folder.rg10.values[i])}]
                .push_back(i);
        }
    }
    return kinds;
}

}  // namespace

double Ground::roughness_m() const {
    return stops_all
               ? 0.0
               : std::min(10.0,
                          std::sqrt(0.7 * rg70_m * rg70_m + 0.2 * rg20_m * rg20_m + 0.1 * rg10_m * rg10_m));
}

double tangential_share(double rg70_m, double rg20_m, double rg10_m, double rock_radius_m) {
    const double energy = 0.7 * energy_share(rg70_m, rock_radius_m) +
                          0.2 * energy_share(rg20_m, rock_radius_m) +
                          0.1 * energy_share(rg10_m, rock_radius_m);
    return std::sqrt((0.4 + energy) / 1.4);
}

std::string like_ground(int soil_type, double mean_roughness_m) {
    const SoilType& soil = soil_types.at(static_cast<std::size_t>(soil_type));
    return mean_roughness_m < rough_from_m ? soil.smooth : soil.rough;
}

Grounds grounds_of(const Folder& folder, double rock_radius_m, std::size_t most_types) {
    Grounds grounds;
    grounds.codes = config::Raster<double>{folder.dem.frame, std::nan("")};
    long long step_cm = 1;
    auto kinds = kinds_by(folder, step_cm);
    for (const long long coarser_cm : {5, 10, 25, 50, 100, 200, 500, 1000, 2500, 10'000}) {
        if (kinds.size() <= most_types) {
            break;
        }
        step_cm = coarser_cm;
        grounds.step_m = metres(step_cm);
        kinds = kinds_by(folder, step_cm);
    }
    for (const auto& [kind, cells] : kinds) {
        Ground ground;
        ground.code = static_cast<int>(grounds.types.size()) + 1;
        ground.soil_type = static_cast<int>(kind[0]);
        ground.rg70_m = metres(kind[1] * step_cm);
        ground.rg20_m = metres(kind[2] * step_cm);
        ground.rg10_m = metres(kind[3] * step_cm);
        ground.r_n = soil_types.at(static_cast<std::size_t>(ground.soil_type)).r_n;
        ground.r_t = std::min(tangential_share(ground.rg70_m, ground.rg20_m, ground.rg10_m, rock_radius_m),
                              rockfall::largest_restitution);
        ground.stops_all = ground.soil_type == 0 || ground.rg70_m >= stops_all_m;
        if (ground.stops_all) {
            ground.r_n = 0.0;
            ground.r_t = 0.0;
        }
        ground.like = like_ground(ground.soil_type, mean_roughness_m(ground));
        ground.cells = cells.size();
        for (const std::size_t i : cells) {
            grounds.codes.values[i] = ground.code;
        }
        grounds.types.push_back(ground);
    }
    return grounds;
}

}  // namespace coupling::rockyfor3d
