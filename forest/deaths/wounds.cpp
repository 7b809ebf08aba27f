#include "forest/deaths/wounds.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "config/random/stream.hpp"
#include "forest/deadwood/deadwood.hpp"

namespace forest {

namespace {

constexpr double cm_per_m = 100.0;
constexpr double highest_break_m = 3.0;
constexpr double lowest_break_m = 0.1;

constexpr double wound_height_per_width = 1.5;
constexpr double merging_m = 0.3;
constexpr double vitality_by_girth = 0.6;
constexpr double deep_energy_share = 0.2;

constexpr double death_by_girth = 0.03;
constexpr double death_by_energy = 0.02;
constexpr double closing_light = 0.3;
constexpr double closing_cm_pyear = 2.0;  // one from each side
constexpr double recovery_pyear = 0.02;
constexpr double rot_radial_cm_pyear = 0.3;

double ellipse_cm2(double width_cm) {
    return 0.25 * std::numbers::pi * wound_height_per_width * width_cm * width_cm;
}

double girth_share(double width_cm, double dbh_cm) {
    return std::min(1.0, width_cm / (std::numbers::pi * dbh_cm));
}

Wound wound_of(const Impact& hit, const Tree& tree, double energy_share, int year) {
    const double width_cm =
        std::min(cm_per_m * hit.rock_diameter_m, tree.dbh_cm) * (0.3 + 0.5 * std::min(energy_share, 1.0));
    return {.tree = tree.id,
            .year = year,
            .height_m = static_cast<float>(hit.height_m),
            .width_cm = static_cast<float>(width_cm),
            .area_cm2 = static_cast<float>(ellipse_cm2(width_cm)),
            .energy_use = static_cast<float>(energy_share)};
}

/// Wounds of the stand with new ones, near ones of a tree joined: areas add up, the rest is the larger.
std::vector<Wound> joined(std::span<const Wound> old_ones, std::span<const Wound> new_ones) {
    std::vector<Wound> all(old_ones.begin(), old_ones.end());
    for (const Wound& wound : new_ones) {
        all.push_back(wound);
    }
    std::stable_sort(all.begin(), all.end(), [](const Wound& a, const Wound& b) {
        return a.tree != b.tree ? a.tree < b.tree : a.height_m < b.height_m;
    });
    std::vector<Wound> result;
    for (const Wound& wound : all) {
        const bool near = !result.empty() && result.back().tree == wound.tree &&
                          static_cast<double>(wound.height_m - result.back().height_m) < merging_m;
        if (!near) {
            result.push_back(wound);
            continue;
        }
        Wound& below = result.back();
        below.area_cm2 += wound.area_cm2;
        below.width_cm = std::max(below.width_cm, wound.width_cm);
        below.energy_use = std::max(below.energy_use, wound.energy_use);
        below.year = std::max(below.year, wound.year);
    }
    return result;
}

/// The hits of a year, before the stand hears of them.
class Hits {
public:
    Hits(const Stand& stand, const SpeciesTable& species, const UprootingLaw& law, std::uint64_t seed,
         std::uint32_t replicate)
        : stand_{stand}, species_{species}, law_{law}, seed_{seed}, replicate_{replicate} {
        for (const Tree& tree : stand.trees()) {
            vitalities.push_back(tree.vitality);
            rots.push_back(tree.rot);
        }
    }

    void add(const Impact& hit) {
        assert(hit.height_m >= 0.0 && hit.energy_share >= 0.0 && hit.rock_diameter_m > 0.0);
        const std::optional<std::size_t> place = stand_.find(hit.tree);
        if (!place || lost_[hit.tree] >= stand_.trees()[*place].stems) {
            ++report.missed;
            return;
        }
        const Tree& tree = stand_.trees()[*place];
        const config::FourUniforms u =
            config::RandomStream{
                {seed_, replicate_, static_cast<std::uint16_t>(stand_.year()), number_of(tree.id)},
                config::Purpose::wounding}
                .uniforms_of(1 + hits_[hit.tree]++);  // event 0 decides whether it dies of old wounds
        const double energy_share = hit.energy_share / stem_strength(tree, hit.height_m);
        if (hit.frontal && energy_share >= 1.0) {
            fell(hit, tree, u[0] < uprooting_chance(tree));
        } else if (tree.stems == 1) {
            scar(hit, tree, *place, energy_share, u[1]);
        }
    }

    std::vector<Removal> removals;
    std::vector<Snag> snags;
    std::vector<Log> logs;
    std::vector<Wound> wounds;
    std::vector<double> vitalities;
    std::vector<Rot> rots;
    WoundReport report;

private:
    [[nodiscard]] double uprooting_chance(const Tree& tree) const {
        const bool shallow = stand_.grid()[tree.patch].soil.water_capacity_mm <= law_.shallow_mm;
        return shallow ? law_.shallow_soil : law_.deep_soil;
    }

    void fell(const Impact& hit, const Tree& tree, bool uprooted) {
        removals.push_back({tree.id, Cause::rock, 1});
        ++lost_[tree.id];
        ++(uprooted ? report.uprooted : report.broken);
        if (tree.dbh_cm < least_dead_wood_cm) {
            return;
        }
        // Trees of this thickness are taller than that; one that is not breaks below its tip.
        const double break_m = uprooted ? 0.0
                                        : std::min(std::clamp(hit.height_m, lowest_break_m, highest_break_m),
                                                   0.9 * tree.height_m);
        const Wreck wreck =
            wreck_of(tree, break_m, hit.direction_rad, LogOrigin::broken_by_rock, stand_.year());
        logs.push_back(wreck.log);
        if (wreck.stump) {
            snags.push_back(*wreck.stump);
        }
    }

    void scar(const Impact& hit, const Tree& tree, std::size_t place, double energy_share, double u) {
        const Wound wound = wound_of(hit, tree, energy_share, stand_.year());
        wounds.push_back(wound);
        ++report.wounded;
        vitalities[place] *=
            1.0 - vitality_by_girth * girth_share(static_cast<double>(wound.width_cm), tree.dbh_cm);
        const bool lets_rot_in =
            energy_share > deep_energy_share && u < species_[tree.species].wounds.rot_probability;
        if (lets_rot_in && rots[place].depth_cm <= 0.0F) {
            const float half_m =
                0.5F * static_cast<float>(wound_height_per_width / cm_per_m) * wound.width_cm;
            rots[place] = {.since_year = stand_.year(),
                           .from_m = std::max(0.0F, wound.height_m - half_m),
                           .to_m = wound.height_m + half_m,
                           .depth_cm = static_cast<float>(rot_radial_cm_pyear)};
        }
    }

    const Stand& stand_;
    const SpeciesTable& species_;
    UprootingLaw law_;
    std::uint64_t seed_;
    std::uint32_t replicate_;
    std::map<TreeId, std::uint32_t> lost_;
    std::map<TreeId, std::uint32_t> hits_;
};

}  // namespace

double stem_strength(const Tree& tree, double height_m) {
    constexpr double least = 0.2;
    const auto depth_cm = static_cast<double>(tree.rot.depth_cm);
    if (depth_cm <= 0.0 || height_m < static_cast<double>(tree.rot.from_m) ||
        height_m > static_cast<double>(tree.rot.to_m)) {
        return 1.0;
    }
    const double share = std::min(1.0, depth_cm / (0.5 * tree.dbh_cm));
    return std::max(least, 1.0 - share * share * share);
}

WoundReport wound(Stand& stand, const SpeciesTable& species, std::span<const Impact> impacts,
                  const UprootingLaw& law, std::uint64_t seed, std::uint32_t replicate) {
    Hits hits{stand, species, law, seed, replicate};
    for (const Impact& impact : impacts) {
        hits.add(impact);
    }
    stand.set_vitalities(hits.vitalities);
    stand.set_rots(hits.rots);
    stand.set_wounds(joined(stand.wounds(), hits.wounds));
    stand.remove_trees(hits.removals);
    stand.add_snags(hits.snags);
    stand.add_logs(hits.logs);
    return hits.report;
}

double wound_death(const Species& species, double dbh_cm, std::span<const Wound> wounds) {
    double girth = 0.0;
    double energy = 0.0;
    for (const Wound& wound : wounds) {
        girth += girth_share(static_cast<double>(wound.width_cm), dbh_cm);
        energy = std::max(energy, static_cast<double>(wound.energy_use));
    }
    const double conifer = death_by_girth * std::min(girth, 1.0) + death_by_energy * std::min(energy, 1.0);
    return species.conifer ? conifer : 0.5 * conifer;
}

std::vector<Removal> wound_deaths(const Stand& stand, const SpeciesTable& species, std::uint64_t seed,
                                  std::uint32_t replicate) {
    std::vector<Removal> deaths;
    const std::span<const Wound> wounds = stand.wounds();
    for (std::size_t first = 0; first < wounds.size();) {
        std::size_t last = first;
        while (last < wounds.size() && wounds[last].tree == wounds[first].tree) {
            ++last;
        }
        const Tree& tree = stand.trees()[*stand.find(wounds[first].tree)];
        const double p = wound_death(species[tree.species], tree.dbh_cm, wounds.subspan(first, last - first));
        const config::RandomStream stream{
            {seed, replicate, static_cast<std::uint16_t>(stand.year()), number_of(tree.id)},
            config::Purpose::wounding};
        if (stream.uniforms_of(0)[0] < p) {
            deaths.push_back({tree.id, Cause::wound});
        }
        first = last;
    }
    return deaths;
}

void heal(Stand& stand, const SpeciesTable& species) {
    std::vector<double> vitalities;
    std::vector<Rot> rots;
    for (const Tree& tree : stand.trees()) {
        vitalities.push_back(std::min(1.0, tree.vitality + recovery_pyear));
        Rot rot = tree.rot;
        if (rot.depth_cm > 0.0F) {
            // Half of the spread goes either way.
            const auto way_m =
                static_cast<float>(0.5 * species[tree.species].wounds.rot_spread_cmpyear / cm_per_m);
            rot.from_m = std::max(0.0F, rot.from_m - way_m);
            rot.to_m = std::min(static_cast<float>(tree.height_m), rot.to_m + way_m);
            rot.depth_cm = std::min(static_cast<float>(0.5 * tree.dbh_cm),
                                    rot.depth_cm + static_cast<float>(rot_radial_cm_pyear));
        }
        rots.push_back(rot);
    }
    std::vector<Wound> open;
    for (Wound wound : stand.wounds()) {
        if (stand.trees()[*stand.find(wound.tree)].light_ratio > closing_light) {
            const float left_cm = wound.width_cm - static_cast<float>(closing_cm_pyear);
            if (left_cm <= 0.0F) {
                continue;
            }
            wound.area_cm2 *= (left_cm / wound.width_cm) * (left_cm / wound.width_cm);
            wound.width_cm = left_cm;
        }
        open.push_back(wound);
    }
    stand.set_vitalities(vitalities);
    stand.set_rots(rots);
    stand.set_wounds(std::move(open));
}

}  // namespace forest
