#include "forest/disturbance/wind.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

#include "config/math/elementary.hpp"
#include "config/random/stream.hpp"
#include "forest/deadwood/deadwood.hpp"
#include "forest/deaths/wounds.hpp"
#include "forest/stand/allometry.hpp"

namespace forest {

namespace {

constexpr double wind_fall_scatter_deg = 30.0;
constexpr double lowest_wind_break_m = 1.0;
constexpr double highest_wind_break_m = 5.0;

constexpr double beta_a = 1.2;
constexpr int beta_b = 4;

/// Share of a Beta(1.2, 4) below x: x^a sum over j < b of (a)_j / j! (1 - x)^j, exact as b is whole.
double share_below(double x) {
    double sum = 0.0;
    double term = 1.0;
    for (int j = 0; j < beta_b; ++j) {
        sum += term;
        term *= (beta_a + j) / (j + 1.0) * (1.0 - x);
    }
    return config::pow_of(x, beta_a) * sum;
}

/// Quadratic mean diameter of the trees that can be thrown, by window [cm]; 0 where there is none.
std::vector<double> mean_diameters_cm(const Stand& stand, const ThinningWindows& windows) {
    std::vector<double> stems(windows.size(), 0.0);
    std::vector<double> square_cm2(windows.size(), 0.0);
    for (const Tree& tree : stand.trees()) {
        if (tree.dbh_cm >= least_thrown_cm) {
            const std::size_t window = windows.window_of(tree.patch);
            stems[window] += tree.stems;
            square_cm2[window] += tree.stems * tree.dbh_cm * tree.dbh_cm;
        }
    }
    for (std::size_t w = 0; w < windows.size(); ++w) {
        square_cm2[w] = stems[w] > 0.0 ? std::sqrt(square_cm2[w] / stems[w]) : 0.0;
    }
    return square_cm2;
}

double logistic(double x) {
    return 1.0 / (1.0 + config::exp_of(-x));
}

}  // namespace

double storm_intensity(double u) {
    assert(u >= 0.0 && u < 1.0);
    double low = 0.0;
    double high = 1.0;
    for (int halving = 0; halving < 50; ++halving) {
        const double middle = 0.5 * (low + high);
        (share_below(middle) < u ? low : high) = middle;
    }
    return 0.5 * (low + high);
}

std::optional<Storm> storm_of_year(const DisturbanceLaw& law, std::uint64_t seed, std::uint32_t replicate,
                                   int year) {
    assert(law.storm_interval_years >= 1.0);
    if (!law.has_storms()) {
        return std::nullopt;
    }
    const config::FourUniforms u =
        config::RandomStream{{seed, replicate, static_cast<std::uint16_t>(year), 0}, config::Purpose::wind}
            .uniforms_of(0);
    const bool is_asked_for =
        std::find(law.storm_years.begin(), law.storm_years.end(), year) != law.storm_years.end();
    const bool comes_by_chance = law.wind && u[0] * law.storm_interval_years < 1.0;
    if (!is_asked_for && !comes_by_chance) {
        return std::nullopt;
    }
    return Storm{.intensity = is_asked_for ? law.intensity_asked_for : storm_intensity(u[1]),
                 .towards_rad = 2.0 * std::numbers::pi * u[2]};
}

StormResponse storm_response_of(const Species& species) {
    if (species.latin_name.starts_with("Picea ")) {
        return {-4.628, -0.140, 5.409, 0.0014};
    }
    if (species.latin_name.starts_with("Abies ")) {
        return {-4.398, -0.035, 3.619, 0.0095};
    }
    if (species.conifer) {
        return {-5.113, -0.435, 3.849, -0.0238};
    }
    return {-5.078, -0.224, 2.743, 0.580};
}

double storm_death(const StormResponse& response, double dbh_cm, double mean_dbh_cm, double intensity) {
    assert(dbh_cm > 0.0 && mean_dbh_cm > 0.0);
    const double size = std::max(-0.722 + 0.07283 * dbh_cm, 0.01);
    const double relative_size = -0.0949 + 2.8315 * config::ln_of(dbh_cm / mean_dbh_cm);
    return logistic(response.intercept + response.relative_size * relative_size +
                    response.intensity * intensity * config::pow_of(size, response.size_power));
}

double uprooted_share(const Species& species, const Tree& tree) {
    constexpr double fresh_per_dry = 1.85;
    constexpr double pa_per_mpa = 1e6;
    const double dbh_m = 0.01 * tree.dbh_cm;
    const double dry_kg =
        stem_volume_m3(species.allometry, tree.dbh_cm, tree.height_m) * species.allometry.stem_density_kgpm3;
    const double roots_nm = species.wind.anchorage_nmpkg * fresh_per_dry * dry_kg;
    const double soundness = stem_strength(tree, static_cast<double>(tree.rot.from_m));
    const double stem_nm =
        soundness * species.wind.rupture_mpa * pa_per_mpa * std::numbers::pi / 32.0 * dbh_m * dbh_m * dbh_m;
    const double ratio = roots_nm / stem_nm;
    return 1.0 / (1.0 + ratio * ratio * ratio * ratio * ratio);
}

void throw_by_wind(Stand& stand, const SpeciesTable& species, const ThinningWindows& windows,
                   const Storm& storm, std::uint64_t seed, std::uint32_t replicate) {
    const std::vector<double> mean_dbh_cm = mean_diameters_cm(stand, windows);
    std::vector<Removal> thrown;
    std::vector<Snag> stumps;
    std::vector<Log> logs;
    for (const Tree& tree : stand.trees()) {
        if (tree.dbh_cm < least_thrown_cm) {
            continue;
        }
        const config::FourUniforms u =
            config::RandomStream{
                {seed, replicate, static_cast<std::uint16_t>(stand.year()), number_of(tree.id)},
                config::Purpose::wind}
                .uniforms_of(1);  // event 0 is the year's storm
        const Species& kind = species[tree.species];
        if (u[0] >= storm_death(storm_response_of(kind), tree.dbh_cm,
                                mean_dbh_cm[windows.window_of(tree.patch)], storm.intensity)) {
            continue;
        }
        thrown.push_back({tree.id, Cause::wind});
        const bool uprooted = u[1] < uprooted_share(kind, tree);
        const double break_m =
            uprooted ? 0.0
                     : std::min(lowest_wind_break_m + (highest_wind_break_m - lowest_wind_break_m) * u[2],
                                0.9 * tree.height_m);
        const double scatter_rad = wind_fall_scatter_deg * std::numbers::pi / 180.0 * (2.0 * u[3] - 1.0);
        const Wreck wreck =
            wreck_of(tree, break_m, storm.towards_rad + scatter_rad, LogOrigin::windthrow, stand.year());
        logs.push_back(wreck.log);
        if (wreck.stump) {
            stumps.push_back(*wreck.stump);
        }
    }
    stand.remove_trees(thrown);
    stand.add_snags(stumps);
    stand.add_logs(logs);
}

}  // namespace forest
