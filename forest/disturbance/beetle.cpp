#include "forest/disturbance/beetle.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>

#include "config/math/elementary.hpp"
#include "config/random/distributions.hpp"
#include "config/random/stream.hpp"
#include "forest/disturbance/beetle_season.hpp"

namespace forest {

namespace {

constexpr double spread_m = 40.5;
constexpr double farthest_m = 257.0;
constexpr double cohorts_of_brood = 20.0;
constexpr double cohorts_with_sister = 30.0;
constexpr double shortest_outbreak_years = 5.0;
constexpr double longest_outbreak_years = 6.0;
constexpr double ha_per_patch = patch_area_m2 / 10'000.0;

bool is_host(const Tree& tree, const SpeciesTable& species) {
    return species[tree.species].beetle.host && tree.dbh_cm >= least_host_cm;
}

/// Patches where hosts lie that last year's storm threw.
std::vector<char> patches_with_windthrow(const Stand& stand, const SpeciesTable& species) {
    std::vector<char> lying(stand.grid().size(), 0);
    for (const Log& log : stand.dead_wood().logs) {
        const bool breeds = log.origin == LogOrigin::windthrow && log.year == stand.year() - 1 &&
                            species[log.species].beetle.host && log.thick_end_cm >= least_host_cm;
        if (const auto patch = breeds ? stand.grid().at(log.x_m, log.y_m) : std::nullopt) {
            lying[index_of(*patch)] = 1;
        }
    }
    return lying;
}

/// More outbreaks of themselves after dry summers, as odds: (rain of June to August / usual)^-0.9609 (iLand).
double dryness(const ClimateYear& year, double usual_summer_mm) {
    constexpr double driest = 0.1;
    const double rain_mm = year.months[5].prec_mm + year.months[6].prec_mm + year.months[7].prec_mm;
    return config::pow_of(std::max(driest, rain_mm / usual_summer_mm), -0.9609);
}

class Outbreak {
public:
    Outbreak(const Stand& stand, const Site& site, const SpeciesTable& species, const SiteWeather& weather,
             std::uint64_t seed, std::uint32_t replicate)
        : stand_{stand},
          site_{site},
          weather_{weather},
          seed_{seed},
          replicate_{replicate},
          success_{colonisation_success(stand, species)},
          infested_(stand.grid().size(), 0),
          taken_(stand.grid().size(), 0) {
        for (const ClimateYear& year : weather.units) {
            days_.push_back(beetle_days(year, site.latitude()));
            cold_days_.push_back(cold_days(year));
        }
    }

    void wake(std::span<const char> windthrow, const BeetleSources& sources) {
        const double background = 1.0 - config::pow_of(1.0 - sources.background_pha, ha_per_patch);
        for (std::size_t p = 0; p < infested_.size(); ++p) {
            const config::FourUniforms u = uniforms(p, 0);
            const std::uint32_t unit = unit_of(p);
            double odds = background / (1.0 - background);
            if (!weather_.usual_summer_mm.empty()) {
                odds *= dryness(weather_.units[unit], weather_.usual_summer_mm[unit]);
            }
            const std::uint16_t last = stand_.patch_states()[p].beetle_years;
            if (last > 0 && u[0] < winter_survival(cold_days_[unit])) {
                infested_[p] = static_cast<std::uint16_t>(last + 1);
            } else if ((windthrow[p] != 0 && u[1] < sources.in_windthrow) ||
                       (success_[p] >= 0.0 && u[2] < odds / (1.0 + odds))) {
                infested_[p] = 1;
            }
        }
    }

    /// One flight; false without beetles that fly.
    bool fly(int flight) {
        std::vector<std::uint16_t> arrived(infested_.size(), 0);
        std::vector<std::size_t> left;
        for (std::size_t p = 0; p < infested_.size(); ++p) {
            if (infested_[p] == 0) {
                continue;
            }
            const Broods broods = broods_of(days_[unit_of(p)], stand_.patch_states()[p].ground_light);
            if (broods.generations >= flight) {
                send(p, broods.sister, arrived);
                left.push_back(p);
            }
        }
        for (const std::size_t p : left) {
            infested_[p] = 0;
            taken_[p] = 1;
        }
        for (std::size_t p = 0; p < infested_.size(); ++p) {
            if (arrived[p] > 0) {
                infested_[p] = arrived[p];
                taken_[p] = 1;
            }
        }
        return !left.empty();
    }

    /// Whether beetles took or left a patch.
    [[nodiscard]] bool killed(PatchId patch) const { return taken_[index_of(patch)] != 0; }
    /// Age of the outbreak whose beetles are on a patch now, 0 = none are.
    [[nodiscard]] std::uint16_t age_of_wintering(std::size_t patch) const { return infested_[patch]; }

private:
    [[nodiscard]] config::FourUniforms uniforms(std::size_t patch, std::uint32_t event) const {
        return config::RandomStream{{seed_, replicate_, static_cast<std::uint16_t>(stand_.year()), patch},
                                    config::Purpose::beetle}
            .uniforms_of(event);
    }
    [[nodiscard]] std::uint32_t unit_of(std::size_t patch) const {
        return site_.unit_of(PatchId{static_cast<std::uint32_t>(patch)});
    }
    [[nodiscard]] bool can_be_taken(std::size_t patch) const {
        return success_[patch] >= 0.0 && infested_[patch] == 0 && taken_[patch] == 0;
    }

    /// The cohorts of a patch; marks in `arrived` the patches that they take, with the year of the outbreak.
    void send(std::size_t from, bool sister, std::vector<std::uint16_t>& arrived) const {
        const double duration_years =
            shortest_outbreak_years +
            (longest_outbreak_years - shortest_outbreak_years) * uniforms(from, 0)[3];
        const double share = 1.0 - lost_to_enemies(infested_[from], duration_years);
        const auto cohorts = std::lround(share * (sister ? cohorts_with_sister : cohorts_of_brood));
        for (long cohort = 0; cohort < cohorts; ++cohort) {
            const config::FourUniforms u = uniforms(from, static_cast<std::uint32_t>(cohort + 1));
            const std::optional<std::size_t> target = landing_of(from, u);
            if (target && u[3] < success_[*target]) {
                arrived[*target] = std::max(arrived[*target], infested_[from]);
            }
        }
    }

    /// The host patch that a cohort comes upon, if any.
    [[nodiscard]] std::optional<std::size_t> landing_of(std::size_t from,
                                                        const config::FourUniforms& u) const {
        const double dx_m = config::normal(u[0], 0.0, spread_m);
        const double dy_m = config::normal(u[1], 0.0, spread_m);
        if (dx_m * dx_m + dy_m * dy_m > farthest_m * farthest_m) {
            return std::nullopt;
        }
        const PatchGrid& grid = stand_.grid();
        const PatchId start{static_cast<std::uint32_t>(from)};
        const double x_m = grid.x_centre_m(start) + dx_m;
        const double y_m = grid.y_centre_m(start) + dy_m;
        if (!grid.frame().covers(x_m, y_m)) {
            return std::nullopt;
        }
        const config::Cell cell = grid.frame().cell_at(x_m, y_m);
        if (const auto patch = host_at(cell)) {
            return patch;
        }
        // Around the cell, from a neighbour drawn on.
        constexpr std::array<std::array<int, 2>, 8> around = {
            {{0, 1}, {1, 1}, {1, 0}, {1, -1}, {0, -1}, {-1, -1}, {-1, 0}, {-1, 1}}};
        const auto first = static_cast<std::size_t>(8.0 * u[2]);
        for (std::size_t i = 0; i < around.size(); ++i) {
            const auto [rows, columns] = around[(first + i) % around.size()];
            if (const auto patch = host_at({cell.column + columns, cell.row + rows})) {
                return patch;
            }
        }
        return std::nullopt;
    }

    [[nodiscard]] std::optional<std::size_t> host_at(config::Cell cell) const {
        const std::optional<PatchId> patch = stand_.grid().at(cell);
        if (!patch || !can_be_taken(index_of(*patch))) {
            return std::nullopt;
        }
        return index_of(*patch);
    }

    const Stand& stand_;
    const Site& site_;
    SiteWeather weather_;
    std::uint64_t seed_;
    std::uint32_t replicate_;
    std::vector<double> success_;
    std::vector<BeetleDays> days_;
    std::vector<double> cold_days_;
    std::vector<std::uint16_t> infested_;  ///< by patch, year of the outbreak; 0 = no beetles
    std::vector<char> taken_;              ///< by patch, its hosts die
};

}  // namespace

std::vector<double> colonisation_success(const Stand& stand, const SpeciesTable& species) {
    struct Hosts {
        double stems = 0.0;
        double poor = 0.0;
    };
    std::vector<Hosts> hosts(stand.grid().size());
    for (const Tree& tree : stand.trees()) {
        if (is_host(tree, species)) {
            hosts[index_of(tree.patch)].stems += tree.stems;
            hosts[index_of(tree.patch)].poor += tree.stress_years > 0 ? tree.stems : 0.0;
        }
    }
    std::vector<double> success(hosts.size(), -1.0);
    for (std::size_t p = 0; p < hosts.size(); ++p) {
        if (hosts[p].stems > 0.0) {
            const double stress =
                std::max(stand.patch_states()[p].drought_index, hosts[p].poor / hosts[p].stems);
            success[p] = 0.15 + 0.85 * stress;
        }
    }
    return success;
}

double lost_to_enemies(int outbreak_year, double duration_years) {
    return std::clamp(2.0 * (outbreak_year - 1) / duration_years - 1.0, 0.0, 1.0);
}

void attack_by_beetles(Stand& stand, const Site& site, const SpeciesTable& species,
                       const SiteWeather& weather, const BeetleSources& sources, std::uint64_t seed,
                       std::uint32_t replicate) {
    assert(weather.units.size() == site.units().size());
    Outbreak outbreak{stand, site, species, weather, seed, replicate};
    outbreak.wake(patches_with_windthrow(stand, species), sources);
    for (int flight = 1; outbreak.fly(flight); ++flight) {
    }

    std::vector<Removal> killed;
    for (const Tree& tree : stand.trees()) {
        if (outbreak.killed(tree.patch) && is_host(tree, species)) {
            killed.push_back({tree.id, Cause::beetle});
        }
    }
    std::vector<PatchState> states(stand.patch_states().begin(), stand.patch_states().end());
    for (std::size_t p = 0; p < states.size(); ++p) {
        states[p].beetle_years = outbreak.age_of_wintering(p);
    }
    stand.remove_trees(killed);
    stand.set_patch_states(states);
}

}  // namespace forest
