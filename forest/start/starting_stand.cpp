#include "forest/start/starting_stand.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "config/units/constants.hpp"
#include "forest/stand/allometry.hpp"
#include "forest/stand/crown.hpp"
#include "forest/start/height_curve.hpp"
#include "forest/start/places.hpp"
#include "forest/start/settled_crowns.hpp"

namespace forest {

namespace {

using config::breast_height_m;

bool is_plausible(const std::optional<double>& height_m, const Species& species) {
    return height_m && *height_m > breast_height_m &&
           *height_m <= greatest_recorded_height_m(species.height_growth);
}

std::string one_decimal(double value) {
    const auto tenths = std::llround(10.0 * value);
    return std::to_string(tenths / 10) + "." + std::to_string(std::abs(tenths % 10));
}

/// Height curves of a list: by species, and of all together.
class HeightCurves {
public:
    HeightCurves(std::span<const ListedTree> list, const SpeciesTable& species) : fits_(species.size()) {
        std::vector<std::vector<MeasuredHeight>> measured(species.size());
        std::vector<MeasuredHeight> all;
        for (const ListedTree& tree : list) {
            if (is_plausible(tree.height_m, species[tree.species])) {
                measured[index_of(tree.species)].push_back({tree.dbh_cm, *tree.height_m});
                all.push_back({tree.dbh_cm, *tree.height_m});
            }
        }
        for (std::size_t s = 0; s < fits_.size(); ++s) {
            fits_[s] = fit_heights(measured[s]);
        }
        of_all_ = fit_heights(all);
    }

    /// The fit that serves a species, trees = 0 if there is none.
    [[nodiscard]] const HeightFit& fit_for(SpeciesId species) const {
        const HeightFit& own = fits_[index_of(species)];
        return own.trees > 0 ? own : of_all_;
    }
    [[nodiscard]] bool has_own(SpeciesId species) const { return fits_[index_of(species)].trees > 0; }

private:
    std::vector<HeightFit> fits_;
    HeightFit of_all_;
};

void tell_filled(const std::map<SpeciesId, std::size_t>& filled, const HeightCurves& curves,
                 const SpeciesTable& species, config::Warnings& warnings) {
    for (const auto& [id, trees] : filled) {
        const HeightFit& fit = curves.fit_for(id);
        std::string how = "from the growth law of the species, as too few heights were measured";
        if (fit.trees > 0) {
            how = "from a height curve through " + std::to_string(fit.trees) + " measured trees" +
                  (curves.has_own(id) ? "" : " of all species") + " (standard error " +
                  one_decimal(fit.standard_error_m) + " m)";
        }
        warnings.add_note(species[id].latin_name + ": " + std::to_string(trees) + " heights filled in " +
                          how);
    }
}

std::string count_in_words(std::size_t trees, const std::string& what) {
    return std::to_string(trees) + (trees == 1 ? " tree " : " trees ") + what;
}

/// Adds a warning if there is something to count.
void warn_of_count(std::size_t trees, const std::string& what, config::Warnings& warnings) {
    if (trees > 0) {
        warnings.add(count_in_words(trees, what));
    }
}

/// Adds a note if there is something to count.
void note_count(std::size_t trees, const std::string& what, config::Warnings& warnings) {
    if (trees > 0) {
        warnings.add_note(count_in_words(trees, what));
    }
}

std::size_t doubled_places(const std::vector<Tree>& trees) {
    std::vector<std::pair<double, double>> places;
    places.reserve(trees.size());
    for (const Tree& tree : trees) {
        places.emplace_back(tree.x_m, tree.y_m);
    }
    std::sort(places.begin(), places.end());
    return static_cast<std::size_t>(places.end() - std::unique(places.begin(), places.end()));
}

/// Stems and mean diameter of a record over an area.
struct Amount {
    std::size_t trees = 0;
    double mean_dbh_cm = 0.0;
};

Amount amount_of(const SpeciesRecord& record, double area_ha) {
    double mean_dbh_cm = record.mean_dbh_cm.value_or(0.0);
    double stems_pha = record.stems_pha.value_or(0.0);
    if (!record.stems_pha) {
        stems_pha = *record.basal_area_m2pha / basal_area_m2(mean_dbh_cm);
    } else if (record.basal_area_m2pha && stems_pha > 0.0) {
        mean_dbh_cm = std::sqrt(*record.basal_area_m2pha / stems_pha / basal_area_m2(1.0));
    }
    return {static_cast<std::size_t>(std::lround(stems_pha * area_ha)),
            std::max(mean_dbh_cm, smallest_tree_cm)};
}

/// Diameters evenly spaced in a class, in falling order.
std::vector<double> class_diameters_cm(std::size_t trees, double from_cm, double to_cm) {
    std::vector<double> diameters;
    for (std::size_t i = 0; i < trees; ++i) {
        const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(trees);
        diameters.push_back(to_cm - share * (to_cm - from_cm));
    }
    return diameters;
}

}  // namespace

double usual_age_years(const Species& species, double dbh_cm) {
    // Recorded trees are alive and grow: none is taken to be at the end of its life.
    constexpr double oldest = 0.6;  // of the greatest age
    return std::min(dbh_cm / species.records.dbh_growth_cm_pyear, oldest * species.mortality.max_age_years);
}

Tree new_tree(const Species& kind, SpeciesId species, double x_m, double y_m, double dbh_cm, double height_m,
              double age_years) {
    Tree tree;
    tree.x_m = x_m;
    tree.y_m = y_m;
    tree.species = species;
    tree.dbh_cm = dbh_cm;
    tree.height_m = height_m;
    tree.age_years = age_years;
    tree.crown = starting_crown(kind, dbh_cm, height_m);
    const PartMasses masses = part_masses(kind.allometry, dbh_cm, height_m, tree.crown.completeness);
    tree.above_ground_kg = masses.above_ground_kg();
    tree.stem_kg = masses.stem_kg;
    return tree;
}

StartingTrees trees_from_list(std::span<const ListedTree> list, const PatchGrid& grid,
                              const SpeciesTable& species, double degree_days, config::Warnings& warnings) {
    const HeightCurves curves{list, species};
    StartingTrees start;
    std::map<SpeciesId, std::size_t> filled;
    std::size_t too_small = 0;
    std::size_t implausible = 0;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const ListedTree& listed = list[i];
        const Species& kind = species[listed.species];
        assert(listed.dbh_cm > 0.0);
        if (!grid.at(listed.x_m, listed.y_m)) {
            start.outside.push_back(i);
            continue;
        }
        if (listed.dbh_cm < smallest_tree_cm) {
            ++too_small;
            continue;
        }
        double height_m = listed.height_m.value_or(0.0);
        if (!is_plausible(listed.height_m, kind)) {
            implausible += listed.height_m ? 1 : 0;
            ++filled[listed.species];
            const HeightFit& fit = curves.fit_for(listed.species);
            height_m = fit.trees > 0 ? fit.curve.height_m(listed.dbh_cm)
                                     : height_by_growth(kind, listed.dbh_cm, degree_days);
            height_m = std::min(height_m, greatest_recorded_height_m(kind.height_growth));
        }
        start.trees.push_back(new_tree(kind, listed.species, listed.x_m, listed.y_m, listed.dbh_cm, height_m,
                                       listed.age_years.value_or(usual_age_years(kind, listed.dbh_cm))));
        start.trees.back().id = TreeId{listed.id};
    }
    tell_filled(filled, curves, species, warnings);
    warn_of_count(implausible,
                  "had a height of 1.3 m or less or beyond the species' greatest: taken as missing",
                  warnings);
    note_count(too_small, "below 1 cm diameter left out", warnings);
    note_count(start.outside.size(), "outside the forest: obstacles that do not grow", warnings);
    warn_of_count(doubled_places(start.trees), "on the same spot as another", warnings);
    return start;
}

std::string missing_in(const SpeciesRecord& record) {
    if (!record.stems_pha && !record.basal_area_m2pha) {
        return "neither stems nor basal area";
    }
    if (!(record.stems_pha && record.basal_area_m2pha) && !record.mean_dbh_cm) {
        return "no mean diameter, and not both stems and basal area";
    }
    return "";
}

std::vector<Tree> trees_from_record(const StandRecord& record, const PatchGrid& grid,
                                    const SpeciesTable& species, std::uint64_t seed, std::uint32_t replicate,
                                    std::uint64_t first_id) {
    const double area_ha = static_cast<double>(record.patches.size()) * patch_area_m2 / 10'000.0;
    std::vector<Tree> trees;
    std::vector<Place> taken;
    double classed_stems = 0.0;  // not rounded
    for (const SpeciesRecord& part : record.species) {
        assert(missing_in(part).empty());
        const Species& kind = species[part.species];
        Amount amount = amount_of(part, area_ha);
        if (part.class_from_cm) {
            const double stems = part.stems_pha.value_or(0.0) * area_ha;
            amount.trees =
                static_cast<std::size_t>(std::lround(classed_stems + stems) - std::lround(classed_stems));
            classed_stems += stems;
        }
        const double mean_height_m = part.mean_height_m.value_or(
            std::max(1.6, height_by_growth(kind, amount.mean_dbh_cm, record.degree_days)));
        const HeightCurve curve = curve_through(amount.mean_dbh_cm, mean_height_m);
        const std::vector<double> diameters =
            part.class_from_cm ? class_diameters_cm(amount.trees, *part.class_from_cm, *part.class_to_cm)
                               : stand_diameters_cm(record.structure, amount.trees, amount.mean_dbh_cm,
                                                    kind.height_growth.max_dbh_cm);
        const std::vector<Place> places =
            places_for(grid, record.patches, diameters, record.structure,
                       {seed, replicate, first_id + trees.size()}, taken, record.cover);
        for (std::size_t i = 0; i < diameters.size(); ++i) {
            const double height_m =
                std::min(curve.height_m(diameters[i]), greatest_recorded_height_m(kind.height_growth));
            const double age_years = part.age_years.value_or(usual_age_years(kind, diameters[i]));
            Tree tree =
                new_tree(kind, part.species, places[i].x_m, places[i].y_m, diameters[i], height_m, age_years);
            tree.id = TreeId{first_id + trees.size()};
            tree.patch = places[i].patch;
            trees.push_back(tree);
        }
        taken.insert(taken.end(), places.begin(), places.end());
    }
    settle_crowns(trees, species, 10'000.0 * area_ha);
    return trees;
}

}  // namespace forest
