#include "forest/treatment/selection.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "config/random/stream.hpp"
#include "forest/stand/allometry.hpp"
#include "forest/stand/self_thinning.hpp"

namespace forest {

namespace {

constexpr double class_cm = 5.0;
constexpr double first_class_cm = 10.0;

Picks fellable(const Stand& stand, std::span<const std::size_t> candidates) {
    Picks picks;
    for (const std::size_t place : candidates) {
        if (!stand.trees()[place].flags.seed_tree) {
            picks.push_back(place);
        }
    }
    return picks;
}

/// Of the year's own number for each tree.
double rank_of(const Tree& tree, int year, std::uint64_t seed, std::uint32_t replicate) {
    return config::RandomStream{{seed, replicate, static_cast<std::uint16_t>(year), number_of(tree.id)},
                                config::Purpose::treatment}
        .uniforms_of(0)[0];
}

double basal_area_of(const Tree& tree) {
    return tree.stems * basal_area_m2(tree.dbh_cm);
}

double volume_of(const Tree& tree, const SpeciesTable& species) {
    return tree.stems * stem_volume_m3(species[tree.species].allometry, tree.dbh_cm, tree.height_m);
}

double volume_of(const Stand& stand, const SpeciesTable& species, std::span<const std::size_t> places) {
    double sum_m3 = 0.0;
    for (const std::size_t place : places) {
        sum_m3 += volume_of(stand.trees()[place], species);
    }
    return sum_m3;
}

/// The first trees of an order whose measure stays within a share of all candidates'.
template <class Measure>
Picks up_to_share(std::span<const std::size_t> candidates, const Picks& order, double share,
                  Measure measure) {
    double room = 0.0;
    for (const std::size_t place : candidates) {
        room += share * measure(place);
    }
    Picks picks;
    for (const std::size_t place : order) {
        room -= measure(place);
        if (room < 0.0) {
            break;
        }
        picks.push_back(place);
    }
    return picks;
}

/// The same by basal area.
Picks up_to_share(const Stand& stand, std::span<const std::size_t> candidates, const Picks& order,
                  double share) {
    return up_to_share(candidates, order, share,
                       [&stand](std::size_t place) { return basal_area_of(stand.trees()[place]); });
}

Picks thinnest_first(const Stand& stand, Picks picks) {
    std::stable_sort(picks.begin(), picks.end(), [&stand](std::size_t a, std::size_t b) {
        return stand.trees()[a].dbh_cm < stand.trees()[b].dbh_cm;
    });
    return picks;
}

/// The thinnest that may go, until a measure of all candidates is no more than the target.
template <class Measure>
Picks thinnest_down_to(const Stand& stand, std::span<const std::size_t> candidates,
                       std::span<const std::size_t> may_go, double target, Measure measure) {
    double standing = 0.0;
    for (const std::size_t place : candidates) {
        standing += measure(stand.trees()[place]);
    }
    Picks picks;
    for (const std::size_t place : thinnest_first(stand, fellable(stand, may_go))) {
        if (standing <= target) {
            break;
        }
        standing -= measure(stand.trees()[place]);
        picks.push_back(place);
    }
    return picks;
}

/// Stems and squares of diameters of each species, from which relative density follows.
class Density {
public:
    Density(const SpeciesTable& species, double area_ha)
        : species_{species}, area_ha_{area_ha}, stems_(species.size()), squares_cm2_(species.size()) {}

    void add(const Tree& tree, double sign) {
        stems_[index_of(tree.species)] += sign * tree.stems;
        squares_cm2_[index_of(tree.species)] += sign * tree.stems * tree.dbh_cm * tree.dbh_cm;
    }
    [[nodiscard]] double value() const {
        double sum = 0.0;
        for (std::size_t s = 0; s < stems_.size(); ++s) {
            if (stems_[s] > 0.5) {
                const double mean_cm = std::sqrt(squares_cm2_[s] / stems_[s]);
                sum += stems_[s] / area_ha_ / most_stems_pha(species_.all()[s].mortality, mean_cm);
            }
        }
        return sum;
    }

private:
    const SpeciesTable& species_;
    double area_ha_;
    std::vector<double> stems_;
    std::vector<double> squares_cm2_;
};

Density density_of(const Stand& stand, const SpeciesTable& species, std::span<const std::size_t> candidates,
                   double area_ha) {
    assert(area_ha > 0.0 || candidates.empty());
    Density density{species, area_ha};
    for (const std::size_t place : candidates) {
        if (stand.trees()[place].dbh_cm >= counted_dbh_cm) {
            density.add(stand.trees()[place], 1.0);
        }
    }
    return density;
}

double squared_distance_m2(const Tree& a, const Tree& b) {
    const double dx = a.x_m - b.x_m;
    const double dy = a.y_m - b.y_m;
    return dx * dx + dy * dy;
}

/// Candidates of each patch, to find neighbours.
class Neighbourhood {
public:
    Neighbourhood(const Stand& stand, std::span<const std::size_t> candidates)
        : stand_{stand}, on_patch_(stand.grid().size()) {
        for (const std::size_t place : candidates) {
            on_patch_[index_of(stand.trees()[place].patch)].push_back(place);
        }
    }
    /// Calls `visit` for every candidate on the tree's patch and the patches within `reach_m`.
    template <class Visit>
    void around(const Tree& tree, double reach_m, Visit visit) const {
        const config::Cell cell = stand_.grid()[tree.patch].cell;
        const int reach = static_cast<int>(std::ceil(reach_m / patch_side_m));
        for (int row = cell.row - reach; row <= cell.row + reach; ++row) {
            for (int column = cell.column - reach; column <= cell.column + reach; ++column) {
                if (const std::optional<PatchId> patch = stand_.grid().at(config::Cell{column, row})) {
                    std::for_each(on_patch_[index_of(*patch)].begin(), on_patch_[index_of(*patch)].end(),
                                  visit);
                }
            }
        }
    }

private:
    const Stand& stand_;
    std::vector<Picks> on_patch_;
};

/// The best trees of an area, no two too near.
Picks crop_trees(const Stand& stand, std::span<const std::size_t> candidates, double area_ha,
                 const CropTreeThinning& rule) {
    const auto merit = [&](std::size_t place) {
        const Tree& tree = stand.trees()[place];
        const bool favoured =
            std::find(rule.favoured.begin(), rule.favoured.end(), tree.species) != rule.favoured.end();
        constexpr double before_all = 1e6;
        constexpr double before_others = 1e3;
        return tree.dbh_cm + (tree.flags.crop_tree ? before_all : 0.0) + (favoured ? before_others : 0.0);
    };
    Picks order{candidates.begin(), candidates.end()};
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return merit(a) > merit(b); });
    const double spacing_m = 0.7 * std::sqrt(10'000.0 / rule.crop_trees_pha);
    const auto most = static_cast<std::size_t>(std::llround(rule.crop_trees_pha * area_ha));
    const Neighbourhood nearby{stand, candidates};
    std::vector<char> chosen(stand.trees().size(), 0);
    Picks crop;
    for (const std::size_t place : order) {
        if (crop.size() >= most) {
            break;
        }
        const Tree& tree = stand.trees()[place];
        bool free = tree.stems == 1;
        nearby.around(tree, spacing_m, [&](std::size_t other) {
            free = free && (chosen[other] == 0 ||
                            squared_distance_m2(tree, stand.trees()[other]) >= spacing_m * spacing_m);
        });
        if (free) {
            chosen[place] = 1;
            crop.push_back(place);
        }
    }
    return crop;
}

}  // namespace

Picks all_trees(const Stand& stand, std::span<const std::size_t> candidates, double from_dbh_cm) {
    Picks picks = fellable(stand, candidates);
    std::erase_if(picks, [&](std::size_t place) { return stand.trees()[place].dbh_cm < from_dbh_cm; });
    return picks;
}

Picks thin_from_below(const Stand& stand, std::span<const std::size_t> candidates, double basal_area_share) {
    return up_to_share(stand, candidates, thinnest_first(stand, fellable(stand, candidates)),
                       basal_area_share);
}

Picks thin_volume_from_below(const Stand& stand, const SpeciesTable& species,
                             std::span<const std::size_t> candidates, double volume_share) {
    return up_to_share(candidates, thinnest_first(stand, fellable(stand, candidates)), volume_share,
                       [&](std::size_t place) { return volume_of(stand.trees()[place], species); });
}

Picks thin_to_basal_area(const Stand& stand, std::span<const std::size_t> candidates,
                         std::span<const std::size_t> may_go, double area_ha, double target_m2pha) {
    assert(area_ha > 0.0 || candidates.empty());
    return thinnest_down_to(stand, candidates, may_go, target_m2pha * area_ha, basal_area_of);
}

Picks thin_to_stems(const Stand& stand, std::span<const std::size_t> candidates,
                    std::span<const std::size_t> may_go, double area_ha, double target_pha) {
    assert(area_ha > 0.0 || candidates.empty());
    return thinnest_down_to(stand, candidates, may_go, target_pha * area_ha,
                            [](const Tree& tree) { return static_cast<double>(tree.stems); });
}

Picks thickest(const Stand& stand, std::span<const std::size_t> candidates, std::size_t stems) {
    Picks order{candidates.begin(), candidates.end()};
    std::stable_sort(order.begin(), order.end(), [&stand](std::size_t a, std::size_t b) {
        return stand.trees()[a].dbh_cm > stand.trees()[b].dbh_cm;
    });
    std::size_t counted = 0;
    std::size_t trees = 0;
    while (trees < order.size() && counted < stems) {
        counted += stand.trees()[order[trees]].stems;
        ++trees;
    }
    order.resize(trees);
    return order;
}

double relative_density(const Stand& stand, const SpeciesTable& species,
                        std::span<const std::size_t> candidates, double area_ha) {
    return density_of(stand, species, candidates, area_ha).value();
}

Picks thin_to_density(const Stand& stand, const SpeciesTable& species,
                      std::span<const std::size_t> candidates, double area_ha, double target_density) {
    Density density = density_of(stand, species, candidates, area_ha);
    Picks picks;
    for (const std::size_t place : thinnest_first(stand, all_trees(stand, candidates, counted_dbh_cm))) {
        if (density.value() <= target_density) {
            break;
        }
        density.add(stand.trees()[place], -1.0);
        picks.push_back(place);
    }
    return picks;
}

Picks thin_for_crop_trees(const Stand& stand, const SpeciesTable& species,
                          std::span<const std::size_t> candidates, double area_ha,
                          const CropTreeThinning& rule) {
    const Picks crop = crop_trees(stand, candidates, area_ha, rule);
    std::vector<char> spared(stand.trees().size(), 0);
    for (const std::size_t place : crop) {
        spared[place] = 1;
    }
    const Neighbourhood nearby{stand, candidates};
    double room_m3 = rule.most_volume_share * volume_of(stand, species, candidates);
    Picks picks;
    for (const std::size_t place : crop) {
        const Tree& tree = stand.trees()[place];
        struct Competitor {
            double strength;
            std::size_t place;
        };
        std::vector<Competitor> competitors;
        const double reach_m = tree.height_m / rule.a_value;
        // Trees up to twice as thick as a crop tree can press it from beyond its own reach.
        nearby.around(tree, 2.0 * reach_m, [&](std::size_t other) {
            const Tree& rival = stand.trees()[other];
            const double distance_m = std::sqrt(squared_distance_m2(tree, rival));
            const double limit_m = reach_m * rival.dbh_cm / tree.dbh_cm;
            if (spared[other] == 0 && !rival.flags.seed_tree && distance_m < limit_m) {
                competitors.push_back({limit_m - distance_m, other});
            }
        });
        std::stable_sort(competitors.begin(), competitors.end(),
                         [](const Competitor& a, const Competitor& b) {
                             return a.strength != b.strength ? a.strength > b.strength : a.place < b.place;
                         });
        for (std::size_t i = 0; i < std::min(rule.competitors, competitors.size()); ++i) {
            const std::size_t rival = competitors[i].place;
            const double volume_m3 = volume_of(stand.trees()[rival], species);
            if (volume_m3 <= room_m3) {
                room_m3 -= volume_m3;
                spared[rival] = 1;  // chosen: not to be counted again
                picks.push_back(rival);
            }
        }
    }
    return picks;
}

Picks target_diameter(const Stand& stand, std::span<const std::size_t> candidates, double dbh_cm) {
    return all_trees(stand, candidates, dbh_cm);
}

std::vector<double> stems_of_selection_forest(const SelectionForest& aim) {
    std::vector<double> stems;
    double basal_area = 0.0;
    double share = 1.0;
    for (double low_cm = first_class_cm; low_cm + 0.5 * class_cm < aim.max_dbh_cm; low_cm += class_cm) {
        stems.push_back(share);
        basal_area += share * basal_area_m2(low_cm + 0.5 * class_cm);
        share /= aim.q;
    }
    for (double& number : stems) {
        number *= aim.basal_area_m2pha / basal_area;
    }
    return stems;
}

Picks single_tree_selection(const Stand& stand, const SpeciesTable& species,
                            std::span<const std::size_t> candidates, double area_ha,
                            const SelectionForest& aim, std::uint64_t seed, std::uint32_t replicate) {
    const std::vector<double> wanted_pha = stems_of_selection_forest(aim);
    std::vector<Picks> classes(wanted_pha.size() + 1);  // the last: beyond the greatest diameter
    std::vector<double> present(classes.size(), 0.0);
    for (const std::size_t place : candidates) {
        const Tree& tree = stand.trees()[place];
        if (tree.dbh_cm < first_class_cm) {
            continue;
        }
        const auto number = static_cast<std::size_t>((tree.dbh_cm - first_class_cm) / class_cm);
        const std::size_t in = std::min(number, wanted_pha.size());
        present[in] += tree.stems;
        if (!tree.flags.seed_tree) {
            classes[in].push_back(place);
        }
    }
    const auto worth = [&](std::size_t place) {
        const Tree& tree = stand.trees()[place];
        return tree.vitality + tree.light_ratio + rank_of(tree, stand.year(), seed, replicate);
    };
    double room_m3 = aim.most_volume_share * volume_of(stand, species, candidates);
    Picks picks;
    for (std::size_t c = classes.size(); c-- > 0;) {
        double excess = present[c] - (c < wanted_pha.size() ? wanted_pha[c] * area_ha : 0.0);
        std::stable_sort(classes[c].begin(), classes[c].end(),
                         [&](std::size_t a, std::size_t b) { return worth(a) < worth(b); });
        for (const std::size_t place : classes[c]) {
            const double volume_m3 = volume_of(stand.trees()[place], species);
            if (excess < 1.0 || volume_m3 > room_m3) {
                break;
            }
            excess -= stand.trees()[place].stems;
            room_m3 -= volume_m3;
            picks.push_back(place);
        }
    }
    return picks;
}

Picks loosen(const Stand& stand, std::span<const std::size_t> candidates, double basal_area_share,
             std::uint64_t seed, std::uint32_t replicate) {
    Picks order = fellable(stand, candidates);
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return rank_of(stand.trees()[a], stand.year(), seed, replicate) <
               rank_of(stand.trees()[b], stand.year(), seed, replicate);
    });
    return up_to_share(stand, candidates, order, basal_area_share);
}

}  // namespace forest
