#include "forest/disturbance/beetle.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>

#include "config/math/elementary.hpp"
#include "config/random/distributions.hpp"
#include "config/random/stream.hpp"
#include "forest/climate/summary.hpp"
#include "forest/disturbance/beetle_hosts.hpp"
#include "forest/disturbance/beetle_season.hpp"
#include "forest/stand/allometry.hpp"

namespace forest {

namespace {

constexpr double spread_m = 40.5;
constexpr double farthest_m = 257.0;
constexpr double cohorts_of_brood = 4.0;
constexpr double cohorts_with_sister = 6.0;
constexpr double shortest_outbreak_years = 5.0;
constexpr double longest_outbreak_years = 6.0;
constexpr double ha_per_patch = patch_area_m2 / 10'000.0;

// Numbers of draws: a patch's own, then those of its cohorts by flight; a tree's lie apart from both.
constexpr std::uint32_t events_of_flight = 64;
constexpr std::uint32_t first_tree_event = 1U << 20U;

/// Share of a full brood that hosts of a basal area feed [0, 1].
double brood_in(double host_m2) {
    return std::min(1.0, host_m2 / full_brood_m2);
}

/// Basal area of hosts by patch that last year's storm threw and that lie there [m2].
std::vector<double> windthrown_m2(const Stand& stand, const SpeciesTable& species) {
    std::vector<double> lying_m2(stand.grid().size(), 0.0);
    for (const Log& log : stand.dead_wood().logs) {
        const bool breeds = log.origin == LogOrigin::windthrow && log.year == stand.year() - 1 &&
                            species[log.species].beetle.host && log.thick_end_cm >= least_host_cm;
        if (const auto patch = breeds ? stand.grid().at(log.x_m, log.y_m) : std::nullopt) {
            lying_m2[index_of(*patch)] += basal_area_m2(log.thick_end_cm);
        }
    }
    return lying_m2;
}

/// More outbreaks of themselves after dry summers, as odds: (rain of June to August / usual)^-0.9609 (iLand).
double dryness(const ClimateYear& year, double usual_summer_mm) {
    constexpr double driest = 0.1;
    const double rain_mm = year.months[5].prec_mm + year.months[6].prec_mm + year.months[7].prec_mm;
    return config::pow_of(std::max(driest, rain_mm / usual_summer_mm), -0.9609);
}

/// More outbreaks of themselves in warm years, as odds: three times in a year of 400 degree-days above the
/// usual ones, about 2 K.
double heat(double degree_days, double usual_degree_days) {
    constexpr double per_degree_day = 0.00275;
    return config::exp_of(per_degree_day * (degree_days - usual_degree_days));
}

/// A host, alive until a cohort kills it.
struct BeetleTree {
    TreeId id{};
    double basal_area_m2 = 0.0;
    double success = 0.0;  ///< of one cohort
    bool alive = true;
};

/// Beetles on a patch.
struct BeetleColony {
    std::uint16_t outbreak_year = 0;  ///< of the outbreak that they belong to, 0 = no beetles
    double brood = 0.0;               ///< share of a full one [0, 1]
};

/// Cohorts that land on a patch in a flight.
struct BeetleLanding {
    int cohorts = 0;
    std::uint16_t outbreak_year = 0;  ///< of the oldest among them
};

class Outbreak {
public:
    Outbreak(const Stand& stand, const Site& site, const SpeciesTable& species, const SiteWeather& weather,
             const SpeciesDrought& drought, std::uint64_t seed, std::uint32_t replicate)
        : stand_{stand},
          site_{site},
          weather_{weather},
          seed_{seed},
          replicate_{replicate},
          hosts_(stand.grid().size()),
          colonies_(stand.grid().size()) {
        for (const ClimateYear& year : weather.units) {
            days_.push_back(beetle_days(year, site.latitude()));
            cold_days_.push_back(cold_days(year));
            degree_days_.push_back(degree_days(year));
        }
        const std::vector<BeetleHosts> around = beetle_hosts_of(stand, species);
        for (const Tree& tree : stand.trees()) {
            if (is_beetle_host(tree, species)) {
                const std::size_t p = index_of(tree.patch);
                hosts_[p].push_back({tree.id, tree.stems * basal_area_m2(tree.dbh_cm),
                                     colonisation_success(
                                         tree, 1.0 - drought.response(tree.patch, tree.species), around[p])});
            }
        }
    }

    void wake(std::span<const double> thrown_m2, const BeetleSources& sources) {
        const double background = 1.0 - config::pow_of(1.0 - sources.background_pha, ha_per_patch);
        for (std::size_t p = 0; p < colonies_.size(); ++p) {
            const config::FourUniforms u = uniforms(p, 0);
            const std::uint32_t unit = unit_of(p);
            double odds = background / (1.0 - background);
            if (!weather_.usual_summer_mm.empty()) {
                odds *= dryness(weather_.units[unit], weather_.usual_summer_mm[unit]);
            }
            const PatchState& last = stand_.patch_states()[p];
            odds *= heat(degree_days_[unit], last.usual_degree_days);
            if (last.beetle_years > 0 && u[0] < winter_survival(cold_days_[unit])) {
                colonies_[p] = {static_cast<std::uint16_t>(last.beetle_years + 1),
                                static_cast<double>(last.beetle_brood)};
            } else if (thrown_m2[p] > 0.0 && u[1] < sources.in_windthrow) {
                colonies_[p] = {1, brood_in(thrown_m2[p])};
            } else if (has_host(p) && u[2] < odds / (1.0 + odds)) {
                colonies_[p] = {1, 1.0};
            }
        }
    }

    /// One flight; false without beetles that fly.
    bool fly(std::uint32_t flight) {
        std::vector<BeetleLanding> landings(colonies_.size());
        std::vector<std::size_t> left;
        for (std::size_t p = 0; p < colonies_.size(); ++p) {
            if (colonies_[p].outbreak_year == 0) {
                continue;
            }
            const Broods broods = broods_of(days_[unit_of(p)], stand_.patch_states()[p].ground_light);
            if (broods.generations >= static_cast<int>(flight)) {
                send(p, broods.sister, flight, landings);
                left.push_back(p);
            }
        }
        for (const std::size_t p : left) {
            colonies_[p] = {};
        }
        for (std::size_t p = 0; p < landings.size(); ++p) {
            settle(p, landings[p], flight);
        }
        return !left.empty();
    }

    /// Hosts that died.
    [[nodiscard]] std::vector<Removal> killed() const {
        std::vector<Removal> removals;
        for (const std::vector<BeetleTree>& patch : hosts_) {
            for (const BeetleTree& tree : patch) {
                if (!tree.alive) {
                    removals.push_back({tree.id, Cause::beetle});
                }
            }
        }
        return removals;
    }
    /// Beetles that are on a patch now.
    [[nodiscard]] const BeetleColony& wintering(std::size_t patch) const { return colonies_[patch]; }

private:
    [[nodiscard]] config::FourUniforms uniforms(std::uint64_t patch_or_tree, std::uint32_t event) const {
        return config::RandomStream{
            {seed_, replicate_, static_cast<std::uint16_t>(stand_.year()), patch_or_tree},
            config::Purpose::beetle}
            .uniforms_of(event);
    }
    [[nodiscard]] std::uint32_t unit_of(std::size_t patch) const {
        return site_.unit_of(PatchId{static_cast<std::uint32_t>(patch)});
    }
    [[nodiscard]] bool has_host(std::size_t patch) const {
        return std::any_of(hosts_[patch].begin(), hosts_[patch].end(),
                           [](const BeetleTree& tree) { return tree.alive; });
    }

    /// The cohorts of a patch and where they land.
    void send(std::size_t from, bool sister, std::uint32_t flight,
              std::vector<BeetleLanding>& landings) const {
        const double duration_years =
            shortest_outbreak_years +
            (longest_outbreak_years - shortest_outbreak_years) * uniforms(from, 0)[3];
        const std::uint16_t year = colonies_[from].outbreak_year;
        const double share = colonies_[from].brood * (1.0 - lost_to_enemies(year, duration_years));
        const auto cohorts = std::lround(share * (sister ? cohorts_with_sister : cohorts_of_brood));
        for (long cohort = 0; cohort < cohorts; ++cohort) {
            const auto event = static_cast<std::uint32_t>(cohort + 1) + flight * events_of_flight;
            const std::optional<std::size_t> target =
                cohort == 0 && has_host(from) ? std::optional{from} : landing_of(from, uniforms(from, event));
            if (target) {
                BeetleLanding& landing = landings[*target];
                ++landing.cohorts;
                landing.outbreak_year = std::max(landing.outbreak_year, year);
            }
        }
    }

    /// What the cohorts kill on a patch, and the brood that they have there.
    void settle(std::size_t patch, const BeetleLanding& landing, std::uint32_t flight) {
        double killed_m2 = 0.0;
        for (BeetleTree& tree : hosts_[patch]) {
            if (landing.cohorts == 0 || !tree.alive) {
                continue;
            }
            const double survival = config::pow_of(1.0 - tree.success, landing.cohorts);
            if (uniforms(number_of(tree.id), first_tree_event + flight)[0] >= survival) {
                tree.alive = false;
                killed_m2 += tree.basal_area_m2;
            }
        }
        if (killed_m2 > 0.0) {
            BeetleColony& colony = colonies_[patch];
            colony.outbreak_year = std::max(colony.outbreak_year, landing.outbreak_year);
            colony.brood = std::min(1.0, colony.brood + brood_in(killed_m2));
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
        if (!patch || !has_host(index_of(*patch))) {
            return std::nullopt;
        }
        return index_of(*patch);
    }

    const Stand& stand_;
    const Site& site_;
    SiteWeather weather_;
    std::uint64_t seed_;
    std::uint32_t replicate_;
    std::vector<BeetleDays> days_;
    std::vector<double> cold_days_;
    std::vector<double> degree_days_;             ///< above 5.5 degC, by site unit
    std::vector<std::vector<BeetleTree>> hosts_;  ///< by patch, in the order of trees
    std::vector<BeetleColony> colonies_;          ///< by patch
};

}  // namespace

double lost_to_enemies(int outbreak_year, double duration_years) {
    return std::clamp(2.0 * (outbreak_year - 1) / duration_years - 1.0, 0.0, 1.0);
}

void attack_by_beetles(Stand& stand, const Site& site, const SpeciesTable& species,
                       const SiteWeather& weather, const SpeciesDrought& drought,
                       const BeetleSources& sources, std::uint64_t seed, std::uint32_t replicate) {
    assert(weather.units.size() == site.units().size());
    Outbreak outbreak{stand, site, species, weather, drought, seed, replicate};
    outbreak.wake(windthrown_m2(stand, species), sources);
    for (std::uint32_t flight = 1; outbreak.fly(flight); ++flight) {
    }

    std::vector<PatchState> states(stand.patch_states().begin(), stand.patch_states().end());
    for (std::size_t p = 0; p < states.size(); ++p) {
        states[p].beetle_years = outbreak.wintering(p).outbreak_year;
        states[p].beetle_brood = static_cast<float>(outbreak.wintering(p).brood);
    }
    stand.remove_trees(outbreak.killed());
    stand.set_patch_states(states);
}

}  // namespace forest
