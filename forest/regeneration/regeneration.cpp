#include "forest/regeneration/regeneration.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "config/math/elementary.hpp"
#include "config/random/stream.hpp"
#include "forest/climate/summary.hpp"
#include "forest/production/nitrogen.hpp"
#include "forest/regeneration/establishment.hpp"
#include "forest/regeneration/ground_cover.hpp"
#include "forest/regeneration/seed_rain.hpp"
#include "forest/saplings/saplings.hpp"
#include "forest/stand/allometry.hpp"
#include "forest/start/starting_stand.hpp"

namespace forest {

namespace {

constexpr double most_seedlings = 200.0;  // of a species, patch and year [choice]
/// Species with room for fewer seedlings get none: they would be many small cohorts that change nothing.
constexpr double least_room_stems = 5.0;

/// Snow glides on open slopes steeper than this that are under snow at the end of the year, unless wood lies
/// there to hold it [choice].
constexpr double gliding_slope_deg = 35.0;
constexpr double gliding_light = 0.6;
constexpr double gliding_snow_mm = 50.0;
constexpr double holding_wood = 0.05;

/// Key of the random numbers of a patch.
struct Chance {
    std::uint64_t seed = 0;
    std::uint32_t replicate = 0;
    int year = 0;

    [[nodiscard]] config::RandomStream of(std::size_t patch, config::Purpose purpose) const {
        return config::RandomStream{{seed, replicate, static_cast<std::uint16_t>(year), patch}, purpose};
    }
};

/// What the climate of a site unit means for each species.
struct UnitClimate {
    double degree_days = 0.0;
    std::vector<double> warmth;  ///< response of young trees, by species
    std::vector<double> chance;  ///< of establishment, by species
};

std::vector<UnitClimate> climates_of(const SpeciesTable& species, std::span<const ClimateYear> weather) {
    std::vector<UnitClimate> units(weather.size());
    for (std::size_t u = 0; u < weather.size(); ++u) {
        units[u].degree_days = degree_days(weather[u]);
        for (const Species& kind : species.all()) {
            units[u].warmth.push_back(degree_day_response(kind.response, units[u].degree_days));
            units[u].chance.push_back(climate_chance(kind, weather[u]));
        }
    }
    return units;
}

/// Cohorts of each patch, in the order they came.
class CohortsByPatch {
public:
    explicit CohortsByPatch(const Stand& stand) : first_(stand.grid().size() + 1, 0) {
        for (const Cohort& cohort : stand.cohorts()) {
            ++first_[index_of(cohort.patch) + 1];
        }
        for (std::size_t i = 1; i < first_.size(); ++i) {
            first_[i] += first_[i - 1];
        }
        places_.resize(stand.cohorts().size());
        std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
        for (std::size_t i = 0; i < places_.size(); ++i) {
            places_[next[index_of(stand.cohorts()[i].patch)]++] = i;
        }
    }
    [[nodiscard]] std::span<std::size_t> of(std::size_t patch) {
        return std::span{places_}.subspan(first_[patch], first_[patch + 1] - first_[patch]);
    }

private:
    std::vector<std::size_t> first_;
    std::vector<std::size_t> places_;
};

SaplingPlace place_of(const Stand& stand, const GroundCover& cover, std::size_t patch, double deer) {
    const PatchState& state = stand.patch_states()[patch];
    const bool steep = stand.grid().patches()[patch].slope.in_degrees() > gliding_slope_deg;
    return {.environment = 1.0,
            .ground_light = state.ground_light,
            .deer = state.fenced_years > 0 ? 0.0 : deer,
            .snow_glides = steep && state.ground_light > gliding_light &&
                           state.snow_water_mm >= gliding_snow_mm &&
                           cover.rotten_wood + cover.fresh_wood < holding_wood};
}

void grow_saplings(Stand& stand, const Site& site, const SpeciesTable& species,
                   std::span<const UnitClimate> climates, const SpeciesDrought& drought,
                   std::span<const GroundCover> covers, double deer, const Chance& chance) {
    CohortsByPatch by_patch{stand};
    std::vector<CohortGrowth> growth(stand.cohorts().size());
    std::vector<SaplingRemoval> deaths;
    const auto note = [&deaths](std::size_t cohort, std::uint32_t stems, Cause cause) {
        if (stems > 0) {
            deaths.push_back({cohort, stems, cause});
        }
    };
    for (std::size_t patch = 0; patch < stand.grid().size(); ++patch) {
        const std::span<const std::size_t> here = by_patch.of(patch);
        if (here.empty()) {
            continue;
        }
        const UnitClimate& climate = climates[site.unit_of(PatchId{static_cast<std::uint32_t>(patch)})];
        const SaplingPlace place = place_of(stand, covers[patch], patch, deer);
        const double nitrogen_kg = stand.grid().patches()[patch].soil.nitrogen_kg_per_ha_year;
        const config::RandomStream stream = chance.of(patch, config::Purpose::sapling);
        for (std::size_t k = 0; k < here.size(); ++k) {
            const Cohort& cohort = stand.cohorts()[here[k]];
            const Species& kind = species[cohort.species];
            SaplingPlace own = place;
            // ForClim takes the geometric mean of the three responses (v3.0, Eq. 4.8). Its cube root of
            // warmth lets spruce lead at the timber line (forest_belts), so warmth is not dampened here.
            own.environment = climate.warmth[index_of(cohort.species)] *
                              config::pow_of(drought.response(cohort.patch, cohort.species) *
                                                 nitrogen_response(kind.response.nitrogen_class, nitrogen_kg),
                                             1.0 / 3.0);
            own.deer = cohort.guarded_years > 0 ? 0.0 : own.deer;
            const SaplingYear year =
                year_of_cohort(kind, cohort, own, stream.uniforms_of(static_cast<std::uint32_t>(k)));
            growth[here[k]] = year.growth;
            note(here[k], year.browsed, Cause::browsing);
            note(here[k], year.stressed, Cause::stress);
            note(here[k], year.torn_out, Cause::snow);
            note(here[k], year.background, Cause::background);
        }
    }
    stand.grow_cohorts(growth);
    stand.remove_saplings(deaths);
}

/// Saplings under trees that fell.
void crush_saplings(Stand& stand, const Chance& chance) {
    const std::vector<double> shares = crushed_shares(stand);
    std::vector<SaplingRemoval> crushed;
    for (std::size_t i = 0; i < stand.cohorts().size(); ++i) {
        const Cohort& cohort = stand.cohorts()[i];
        if (const double share = shares[index_of(cohort.patch)]; share > 0.0) {
            const double u = chance.of(index_of(cohort.patch), config::Purpose::sapling)
                                 .uniforms_of(0x800000U + static_cast<std::uint32_t>(i))[0];
            const auto stems = std::min(cohort.stems, static_cast<std::uint32_t>(cohort.stems * share + u));
            if (stems > 0) {
                crushed.push_back({i, stems, Cause::felled});
            }
        }
    }
    stand.remove_saplings(crushed);
}

void pass_fenced_year(Stand& stand) {
    std::vector<PatchState> states(stand.patch_states().begin(), stand.patch_states().end());
    for (PatchState& state : states) {
        if (state.fenced_years > 0) {
            --state.fenced_years;
        }
    }
    stand.set_patch_states(states);
}

/// Parts of a room for those who want it: none gets more than it wants, and what one leaves the others share
/// evenly.
std::vector<double> even_parts(std::span<const double> wanted, double room) {
    std::vector<std::size_t> order(wanted.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [wanted](std::size_t a, std::size_t b) { return wanted[a] < wanted[b]; });
    std::vector<double> parts(wanted.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const double even = room / static_cast<double>(order.size() - i);
        parts[order[i]] = std::min(wanted[order[i]], even);
        room -= parts[order[i]];
    }
    return parts;
}

/// Takes saplings off patches that are too full: species share the room evenly, in each the tallest stay.
void thin_saplings(Stand& stand) {
    CohortsByPatch by_patch{stand};
    const std::span<const Cohort> cohorts = stand.cohorts();
    std::vector<SaplingRemoval> removals;
    std::vector<double> wanted(stand.species_count());
    for (std::size_t patch = 0; patch < stand.grid().size(); ++patch) {
        const std::span<std::size_t> here = by_patch.of(patch);
        std::fill(wanted.begin(), wanted.end(), 0.0);
        double all = 0.0;
        for (const std::size_t place : here) {
            const double room = cohorts[place].stems * room_of_stem(cohorts[place].height_m);
            wanted[index_of(cohorts[place].species)] += room;
            all += room;
        }
        if (all <= 1.0) {
            continue;
        }
        std::stable_sort(here.begin(), here.end(), [cohorts](std::size_t a, std::size_t b) {
            return cohorts[a].height_m > cohorts[b].height_m;
        });
        std::vector<double> rooms = even_parts(wanted, 1.0);
        for (const std::size_t place : here) {
            const double each = room_of_stem(cohorts[place].height_m);
            double& room = rooms[index_of(cohorts[place].species)];
            const auto fit = std::min(cohorts[place].stems, static_cast<std::uint32_t>(room / each + 1e-9));
            if (fit < cohorts[place].stems) {
                removals.push_back({place, cohorts[place].stems - fit, Cause::self_thinning});
            }
            room = std::max(0.0, room - fit * each);
        }
    }
    stand.remove_saplings(removals);
}

void recruit_trees(Stand& stand, const SpeciesTable& species, const Chance& chance) {
    std::vector<std::size_t> places;
    std::vector<Tree> trees;
    std::vector<std::uint32_t> on_patch(stand.grid().size(), 0);
    for (std::size_t i = 0; i < stand.cohorts().size(); ++i) {
        const Cohort& cohort = stand.cohorts()[i];
        if (cohort.height_m < recruitment_height_m) {
            continue;
        }
        const std::size_t patch = index_of(cohort.patch);
        const config::FourUniforms u =
            chance.of(patch, config::Purpose::young_place).uniforms_of(on_patch[patch]++);
        // Never quite the patch's edge: a place on it may belong to the neighbour.
        const auto beside_m = [](double uniform) { return 0.98 * (uniform - 0.5) * patch_side_m; };
        Tree tree = new_tree(species[cohort.species], cohort.species,
                             stand.grid().x_centre_m(cohort.patch) + beside_m(u[0]),
                             stand.grid().y_centre_m(cohort.patch) + beside_m(u[1]), smallest_tree_cm,
                             cohort.height_m, cohort.age_years);
        tree.stems = cohort.stems;
        tree.origin = cohort.origin;
        tree.light_ratio = stand.patch_states()[patch].ground_light;
        places.push_back(i);
        trees.push_back(tree);
    }
    stand.recruit(places, trees);
}

/// Room that saplings take, by patch and species.
std::vector<double> rooms_taken(const Stand& stand) {
    std::vector<double> rooms(stand.grid().size() * stand.species_count(), 0.0);
    for (const Cohort& cohort : stand.cohorts()) {
        rooms[index_of(cohort.patch) * stand.species_count() + index_of(cohort.species)] +=
            cohort.stems * room_of_stem(cohort.height_m);
    }
    return rooms;
}

/// Seedlings of a species that are to be expected on a patch.
struct ExpectedSeedlings {
    double stems = 0.0;
    double share_on_wood = 0.0;
};

/// Expected seedlings of every species on a patch.
void expect_seedlings(const Stand& stand, const SpeciesTable& species, const SeedRain& rain,
                      const UnitClimate& climate, const SpeciesDrought& drought, std::size_t patch,
                      const GroundCover& cover, std::span<ExpectedSeedlings> expected) {
    const PatchState& state = stand.patch_states()[patch];
    const double sun = sun_chance(climate.degree_days, state.june_sun_hours);
    for (std::size_t s = 0; s < species.size(); ++s) {
        const SpeciesId id{static_cast<std::uint16_t>(s)};
        const Species& kind = species[id];
        const double seeds_pm2 = rain.seedlings_pm2(id, PatchId{static_cast<std::uint32_t>(patch)});
        const double chance =
            climate.chance[s] * sun * light_chance(kind.light, state.ground_light) *
            water_chance(1.0 - drought.response(PatchId{static_cast<std::uint32_t>(patch)}, id));
        const SeedBed bed = seed_bed(kind, cover);
        const double all = bed.ground + bed.wood;
        expected[s] = {.stems = std::min(most_seedlings, patch_area_m2 * seeds_pm2 * chance * all),
                       .share_on_wood = all > 0.0 ? bed.wood / all : 0.0};
    }
}

void establish(Stand& stand, const Site& site, const SpeciesTable& species,
               std::span<const UnitClimate> climates, const SpeciesDrought& drought,
               std::span<const GroundCover> covers, const SeedRain& rain, const Chance& chance) {
    const std::vector<double> taken = rooms_taken(stand);
    const double each = room_of_stem(seedling_height_m);
    std::vector<Cohort> seedlings;
    std::vector<ExpectedSeedlings> expected(species.size());
    std::vector<double> wanted(species.size());
    for (std::size_t patch = 0; patch < stand.grid().size(); ++patch) {
        const PatchId id{static_cast<std::uint32_t>(patch)};
        expect_seedlings(stand, species, rain, climates[site.unit_of(id)], drought, patch, covers[patch],
                         expected);
        const std::span<const double> here = std::span{taken}.subspan(patch * species.size(), species.size());
        for (std::size_t s = 0; s < expected.size(); ++s) {
            wanted[s] = here[s] + expected[s].stems * each;
        }
        const std::vector<double> rooms = even_parts(wanted, 1.0);
        const config::RandomStream stream = chance.of(patch, config::Purpose::establishment);
        for (std::size_t s = 0; s < expected.size(); ++s) {
            const double room_stems = std::max(0.0, rooms[s] - here[s]) / each;
            if (room_stems < std::min(expected[s].stems, least_room_stems)) {
                continue;
            }
            const config::FourUniforms u = stream.uniforms_of(static_cast<std::uint32_t>(s));
            const auto stems = static_cast<std::uint32_t>(std::min(room_stems, expected[s].stems) + u[0]);
            const auto on_wood =
                std::min(stems, static_cast<std::uint32_t>(stems * expected[s].share_on_wood + u[1]));
            for (const bool wood : {false, true}) {
                const std::uint32_t here_stems = wood ? on_wood : stems - on_wood;
                if (here_stems > 0) {
                    seedlings.push_back({.patch = id,
                                         .species = SpeciesId{static_cast<std::uint16_t>(s)},
                                         .origin = Origin::seed,
                                         .stems = here_stems,
                                         .height_m = seedling_height_m,
                                         .on_wood = wood});
                }
            }
        }
    }
    stand.add_cohorts(seedlings);
}

}  // namespace

std::vector<Cohort> sprouts_of(const Stand& stand, const SpeciesTable& species) {
    constexpr double thickest_cm = 30.0;
    constexpr std::uint32_t each = 3;
    constexpr double height_m = 0.5;
    std::vector<Cohort> sprouts;
    for (const Snag& snag : stand.dead_wood().snags) {
        const bool broken = snag.cut || snag.height_m < snag.tree_height_m;
        if (snag.year != stand.year() - 1 || !broken || snag.dbh_cm >= thickest_cm ||
            !species[snag.species].wounds.resprouts) {
            continue;
        }
        if (const std::optional<PatchId> patch = stand.grid().at(snag.x_m, snag.y_m)) {
            sprouts.push_back({.patch = *patch,
                               .species = snag.species,
                               .origin = Origin::sprout,
                               .stems = each,
                               .height_m = height_m});
        }
    }
    return sprouts;
}

void regenerate(Stand& stand, const Site& site, const SpeciesTable& species,
                std::span<const ClimateYear> weather, const SpeciesDrought& drought,
                const RegenerationLaw& law, std::uint64_t seed, std::uint32_t replicate) {
    assert(weather.size() == site.units().size());
    const Chance chance{seed, replicate, stand.year()};
    const std::vector<UnitClimate> climates = climates_of(species, weather);

    std::vector<PatchState> states(stand.patch_states().begin(), stand.patch_states().end());
    std::transform(states.begin(), states.end(), states.begin(), after_year_of_herbs);
    stand.set_patch_states(states);

    const std::vector<GroundCover> covers = ground_covers(stand);
    crush_saplings(stand, chance);
    grow_saplings(stand, site, species, climates, drought, covers, law.browsing_pressure, chance);
    pass_fenced_year(stand);
    thin_saplings(stand);
    recruit_trees(stand, species, chance);

    const SeedRain rain{stand, species, crops_of_year(species, seed, replicate, stand.year()), law.outside};
    establish(stand, site, species, climates, drought, covers, rain, chance);
    thin_saplings(stand);
    stand.add_cohorts(sprouts_of(stand, species));
}

}  // namespace forest
