#include "coupling/exchange/regimes/apply.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "coupling/exchange/regimes/due.hpp"
#include "coupling/exchange/regimes/stem_numbers.hpp"
#include "forest/treatment/groups.hpp"
#include "forest/treatment/young.hpp"

namespace coupling {

namespace {

/// Carries out a year.
class Crew {
public:
    Crew(const Regime& regime, int year, forest::Stand& stand, const forest::SpeciesTable& species,
         RegimeState& state, const forest::YearKey& key)
        : regime_{regime}, year_{year}, stand_{stand}, species_{species}, state_{state}, key_{key} {}

    /// Returns what was due beside the report of it.
    std::pair<std::vector<Due>, RegimeReport> work() {
        RegimeReport report;
        std::vector<Due> due = due_in(regime_, year_, stand_, species_, state_, DueRows::before_marking);
        std::stable_sort(due.begin(), due.end(),
                         [&](const Due& a, const Due& b) { return comes_before(a, b); });
        std::vector<std::vector<forest::TreeId>> marked;
        for (const Due& row : due) {
            Entry entry = empty_entry(row);
            marked.push_back(mark(row, entry));
            report.entries.push_back(entry);
        }
        add_late_rows(DueRows::after_marking, due, marked, report);
        carry_out(due, marked, report);
        return {std::move(due), std::move(report)};
    }

private:
    /// By the order that the user gave, rows without one first, else as they stand in the table.
    [[nodiscard]] bool comes_before(const Due& a, const Due& b) const {
        const auto key = [&](const Due& due) {
            return std::pair{regime_.interventions()[due.intervention].order.value_or(0), due.intervention};
        };
        return key(a) < key(b);
    }

    /// Rows that act on cuts, in their places among the others; of one that is there already the new areas.
    void add_late_rows(DueRows rows, std::vector<Due>& due, std::vector<std::vector<forest::TreeId>>& marked,
                       RegimeReport& report) {
        for (Due& row : due_in(regime_, year_, stand_, species_, state_, rows)) {
            const auto same = std::find_if(due.begin(), due.end(), [&](const Due& other) {
                return other.intervention == row.intervention;
            });
            if (same != due.end()) {
                const Entry more = empty_entry(row);
                Entry& entry = report.entries[static_cast<std::size_t>(same - due.begin())];
                entry.areas += more.areas;
                entry.area_ha += more.area_ha;
                same->areas.insert(same->areas.end(), row.areas.begin(), row.areas.end());
                continue;
            }
            const auto at = std::find_if(due.begin(), due.end(),
                                         [&](const Due& other) { return comes_before(row, other); });
            const auto place = at - due.begin();
            report.entries.insert(report.entries.begin() + place, empty_entry(row));
            marked.insert(marked.begin() + place, std::vector<forest::TreeId>{});
            due.insert(at, std::move(row));
        }
    }

    void carry_out(std::vector<Due>& due, std::vector<std::vector<forest::TreeId>>& marked,
                   RegimeReport& report) {
        const auto each = [&](auto wanted, auto step) {
            for (std::size_t i = 0; i < due.size(); ++i) {
                const Intervention& row = regime_.interventions()[due[i].intervention];
                if (wanted(row)) {
                    step(row, i);
                }
            }
        };
        each([](const Intervention& row) { return row.cuts(); },
             [&](const Intervention& row, std::size_t i) {
                 add(fell(marked[i], row), report.entries[i], report);
             });
        each(
            [](const Intervention& row) { return row.treatment == Treatment::salvage; },
            [&](const Intervention& row, std::size_t i) { salvage(due[i], row, report.entries[i], report); });
        add_late_rows(DueRows::after_salvage, due, marked, report);
        each([](const Intervention& row) { return row.treatment == Treatment::tend; },
             [&](const Intervention& row, std::size_t i) {
                 for (const Area* area : areas_of(due[i])) {
                     const forest::TendingDone done = forest::tend(
                         stand_, area->place, {row.species, row.from_height_m, row.to_height_m, row.share});
                     report.entries[i].tended += done.stems;
                     report.entries[i].tended_ha += done.area_ha;
                 }
             });
        each([](const Intervention& row) { return row.treatment == Treatment::fence; },
             [&](const Intervention& row, std::size_t i) {
                 for (const Area* area : areas_of(due[i])) {
                     report.entries[i].fenced_ha += forest::fence(stand_, area->place, row.fence_years);
                 }
             });
        each([](const Intervention& row) { return row.plants(); },
             [&](const Intervention& row, std::size_t i) {
                 for (const Area* area : areas_of(due[i])) {
                     const std::uint64_t plants = plant(row, area->place);
                     report.entries[i].plants += plants;
                     report.entries[i].guarded += row.guard_years > 0 ? plants : 0;
                 }
             });
    }

    void salvage(const Due& due, const Intervention& row, Entry& entry, RegimeReport& report) {
        std::vector<RegimeState::Cut> cuts;
        for (const Area* area : areas_of(due)) {
            forest::Salvaged done = forest::salvage(stand_, species_, area->place, row.share,
                                                    row.oldest_years, row.felling, key_.seed, key_.replicate);
            add(done.timber, entry, report);
            if (!done.patches.empty()) {
                cuts.push_back({static_cast<std::uint32_t>(due.intervention), year_,
                                ground_of(std::move(done.patches))});
            }
        }
        if (regime_.keeps_cuts_of(due.intervention)) {
            keep(std::move(cuts));
        }
    }

    /// The ground of cuts, for the rows that act on it.
    void keep(std::vector<RegimeState::Cut> cuts) {
        for (RegimeState::Cut& cut : cuts) {
            cut.area.number = static_cast<std::uint32_t>(state_.cuts.size());
            cut.area.order = 0;
            state_.cuts.push_back(std::move(cut));
        }
    }

    [[nodiscard]] std::vector<const Area*> areas_of(const Due& due) const {
        std::vector<const Area*> areas;
        for (const std::size_t place : due.areas) {
            areas.push_back(&area_at(regime_, state_, due.intervention, place));
        }
        return areas;
    }

    [[nodiscard]] Entry empty_entry(const Due& due) const {
        const Intervention& row = regime_.interventions()[due.intervention];
        Entry entry{
            .year = year_, .intervention = row.name, .treatment = row.treatment, .areas = due.areas.size()};
        for (const Area* area : areas_of(due)) {
            entry.area_ha += area->area_ha;
        }
        return entry;
    }

    /// Trees that go, area by area; none that an upper row has marked.
    std::vector<forest::TreeId> mark(const Due& due, Entry& entry) {
        const Intervention& row = regime_.interventions()[due.intervention];
        std::vector<forest::TreeId> trees;
        if (!row.cuts()) {
            return trees;
        }
        taken_.resize(stand_.trees().size(), 0);
        if (row.treatment == Treatment::group_cut) {
            entry.area_ha = 0.0;
        }
        std::vector<RegimeState::Cut> cuts;
        for (const Area* area : areas_of(due)) {
            forest::Picks candidates = forest::trees_in(stand_, area->place);
            std::erase_if(candidates, [&](std::size_t place) {
                return taken_[place] != 0 || stand_.trees()[place].dbh_cm < row.from_dbh_cm;
            });
            std::vector<config::Shape> holes;
            const forest::Picks picks = select(due.intervention, candidates, *area, holes);
            for (const std::size_t place : picks) {
                taken_[place] = 1;
                trees.push_back(stand_.trees()[place].id);
                entry.cut_patches.push_back(stand_.trees()[place].patch);
            }
            const double hole_ha = row.groups.side_m * row.groups.side_m / square_metres_per_hectare;
            entry.area_ha += static_cast<double>(holes.size()) * hole_ha;
            if (!regime_.keeps_cuts_of(due.intervention) || picks.empty()) {
                continue;
            }
            const auto intervention = static_cast<std::uint32_t>(due.intervention);
            if (row.treatment == Treatment::fell_list) {
                cuts.push_back({intervention, year_, ground_of(patches_of(picks))});
            } else if (row.treatment != Treatment::group_cut) {
                cuts.push_back({intervention, year_, *area});
            }
            for (const config::Shape& hole : holes) {
                Area cut{.place = area->place, .area_ha = hole_ha};
                cut.place.polygons = {hole};
                cut.patches = forest::patches_in(stand_.grid(), cut.place);
                cuts.push_back({intervention, year_, std::move(cut)});
            }
        }
        std::sort(entry.cut_patches.begin(), entry.cut_patches.end());
        entry.cut_patches.erase(std::unique(entry.cut_patches.begin(), entry.cut_patches.end()),
                                entry.cut_patches.end());
        keep(std::move(cuts));
        return trees;
    }

    /// Patches of some trees, rising.
    [[nodiscard]] std::vector<forest::PatchId> patches_of(const forest::Picks& picks) const {
        std::vector<forest::PatchId> patches;
        for (const std::size_t place : picks) {
            patches.push_back(stand_.trees()[place].patch);
        }
        std::sort(patches.begin(), patches.end());
        patches.erase(std::unique(patches.begin(), patches.end()), patches.end());
        return patches;
    }

    /// Patches as an area: a list of trees and a salvage have no ground of their own.
    [[nodiscard]] Area ground_of(std::vector<forest::PatchId> patches) const {
        Area ground{.patches = std::move(patches)};
        ground.area_ha =
            static_cast<double>(ground.patches.size()) * forest::patch_area_m2 / square_metres_per_hectare;
        config::Shape squares{config::Shape::Kind::polygon, {}};
        constexpr double half_m = 0.5 * forest::patch_side_m;
        for (const forest::PatchId patch : ground.patches) {
            const double x_m = stand_.grid().x_centre_m(patch);
            const double y_m = stand_.grid().y_centre_m(patch);
            squares.parts.push_back({{x_m - half_m, y_m - half_m},
                                     {x_m + half_m, y_m - half_m},
                                     {x_m + half_m, y_m + half_m},
                                     {x_m - half_m, y_m + half_m},
                                     {x_m - half_m, y_m - half_m}});
        }
        ground.place.polygons = {std::move(squares)};
        return ground;
    }

    /// Trees that a row may cut: of its species, without the thickest that it retains.
    [[nodiscard]] forest::Picks allowed(const Intervention& row, const forest::Picks& candidates,
                                        double area_ha) const {
        const auto names = [&](const std::vector<forest::SpeciesId>& list, std::size_t place) {
            return std::find(list.begin(), list.end(), stand_.trees()[place].species) != list.end();
        };
        const auto retain = static_cast<std::size_t>(std::lround(row.retain_pha * area_ha));
        const forest::Picks retained = forest::thickest(stand_, candidates, retain);
        forest::Picks picks;
        for (const std::size_t place : candidates) {
            if ((row.only_species.empty() || names(row.only_species, place)) &&
                !names(row.spare_species, place) &&
                std::find(retained.begin(), retained.end(), place) == retained.end()) {
                picks.push_back(place);
            }
        }
        return picks;
    }

    /// Also where a group cut lies.
    forest::Picks select(std::size_t intervention, const forest::Picks& all_candidates, const Area& area,
                         std::vector<config::Shape>& holes) const {
        const Intervention& row = regime_.interventions()[intervention];
        const forest::Picks candidates = allowed(row, all_candidates, area.area_ha);
        switch (row.treatment) {
            case Treatment::thin_below:
                return row.of_volume ? forest::thin_volume_from_below(stand_, species_, candidates, row.share)
                                     : forest::thin_from_below(stand_, candidates, row.share);
            case Treatment::thin_density:
                return forest::thin_to_density(stand_, species_, candidates, area.area_ha,
                                               row.target_density);
            case Treatment::thin_crop_trees: {
                forest::CropTreeThinning rule = row.crop;
                rule.favoured = row.species;
                return forest::thin_for_crop_trees(stand_, species_, candidates, area.area_ha, rule);
            }
            case Treatment::thin_to_basal_area:
                return forest::thin_to_basal_area(stand_, all_candidates, candidates, area.area_ha,
                                                  row.to_basal_area_m2pha);
            case Treatment::thin_to_stems: {
                const auto stems_pha = stems_at(row.stems_at, area, age_of(intervention, area));
                return stems_pha ? forest::thin_to_stems(stand_, all_candidates, candidates, area.area_ha,
                                                         *stems_pha)
                                 : forest::Picks{};
            }
            case Treatment::target_diameter:
                return forest::target_diameter(stand_, candidates, row.from_dbh_cm);
            case Treatment::selection:
                return forest::single_tree_selection(stand_, species_, candidates, area.area_ha,
                                                     row.selection, key_.seed, key_.replicate);
            case Treatment::shelter_cut:
                return forest::loosen(stand_, candidates, row.share, key_.seed, key_.replicate);
            case Treatment::clear_cut:
                return forest::all_trees(stand_, candidates);
            case Treatment::fell_list:
                return listed(row, candidates);
            case Treatment::group_cut: {
                holes = forest::ripest_groups(stand_, species_, candidates, area.place, row.groups);
                forest::Picks inside;
                for (const std::size_t place : candidates) {
                    const forest::Tree& tree = stand_.trees()[place];
                    if (!holes.empty() && forest::belongs({holes, {}}, stand_.grid(), tree.x_m, tree.y_m)) {
                        inside.push_back(place);
                    }
                }
                return forest::all_trees(stand_, inside);
            }
            default:
                assert(false && "not a cut");
                return {};
        }
    }

    [[nodiscard]] double age_of(std::size_t intervention, const Area& area) const {
        return coupling::age_of(regime_, year_, stand_, state_, intervention, area,
                                forest::trees_in(stand_, area.place));
    }

    /// Trees of the list whose year it is; those that stand no more are left out.
    [[nodiscard]] forest::Picks listed(const Intervention& row, const forest::Picks& candidates) const {
        std::vector<std::uint64_t> numbers;
        for (const ListedTree& tree : row.listed) {
            if (tree.year == year_) {
                numbers.push_back(tree.tree);  // they rise within a year
            }
        }
        forest::Picks picks;
        for (const std::size_t place : candidates) {
            if (std::binary_search(numbers.begin(), numbers.end(),
                                   forest::number_of(stand_.trees()[place].id))) {
                picks.push_back(place);
            }
        }
        return picks;
    }

    forest::Timber fell(const std::vector<forest::TreeId>& trees, const Intervention& row) {
        forest::Picks picks;
        for (const forest::TreeId tree : trees) {
            const auto place = stand_.find(tree);
            assert(place);
            picks.push_back(*place);
        }
        return forest::fell(stand_, species_, picks, row.felling, key_.seed, key_.replicate);
    }

    std::uint64_t plant(const Intervention& row, const forest::TreatmentArea& place) {
        const std::vector<forest::PatchId> patches =
            row.where_fewer_pha ? forest::patches_with_fewer(stand_, place, *row.where_fewer_pha)
                                : forest::patches_in(stand_.grid(), place);
        if (row.treatment == Treatment::plant_clusters) {
            return forest::plant_clusters_on(
                stand_, patches,
                {.species = row.species.front(),
                 .height_m = row.plant_height_m,
                 .guarded_years = row.guard_years},
                static_cast<int>(std::lround(row.spacing_m / forest::patch_side_m)));
        }
        std::uint64_t plants = 0;
        for (std::size_t i = 0; i < row.species.size(); ++i) {
            plants += forest::plant_on(
                stand_, patches, {row.species[i], row.plants_pha[i], row.plant_height_m, row.guard_years},
                key_.seed, key_.replicate);
        }
        return plants;
    }

    static void add(const forest::Timber& timber, Entry& entry, RegimeReport& report) {
        const forest::TimberClass sum = timber.total();
        entry.stems += sum.stems;
        entry.taken_m3 += sum.taken_m3;
        entry.left_m3 += sum.left_m3;
        report.timber += timber;
    }

    static constexpr double square_metres_per_hectare = 10'000.0;

    const Regime& regime_;
    int year_;
    forest::Stand& stand_;
    const forest::SpeciesTable& species_;
    RegimeState& state_;
    forest::YearKey key_;
    std::vector<char> taken_;
};

}  // namespace

RegimeReport apply(const Regime& regime, int year, forest::Stand& stand, const forest::SpeciesTable& species,
                   RegimeState& state, const forest::YearKey& key) {
    auto [due, report] = Crew{regime, year, stand, species, state, key}.work();
    remember(regime, year, due, state);
    return report;
}

}  // namespace coupling
