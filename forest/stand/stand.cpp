#include "forest/stand/stand.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "config/random/stream.hpp"

namespace forest {

namespace {

bool by_id(const Tree& a, const Tree& b) {
    return a.id < b.id;
}

bool by_tree_and_height(const Wound& a, const Wound& b) {
    return a.tree != b.tree ? a.tree < b.tree : a.height_m < b.height_m;
}

}  // namespace

Stand::Stand(PatchGrid grid, std::size_t species_count, std::vector<Tree> trees, int first_year)
    : grid_{std::move(grid)}, species_count_{species_count} {
    now_.year = first_year;
    now_.trees = std::move(trees);
    now_.patch_states.resize(grid_.size());
    std::sort(now_.trees.begin(), now_.trees.end(), by_id);
    for (Tree& tree : now_.trees) {
        const std::optional<PatchId> patch = grid_.at(tree.x_m, tree.y_m);
        assert(patch.has_value() && index_of(tree.species) < species_count_ && tree.stems > 0);
        tree.patch = *patch;
        assert(number_of(tree.id) >= now_.next_id);
        now_.next_id = number_of(tree.id) + 1;
    }
    for (std::size_t i = 0; i < grid_.size(); ++i) {
        now_.patch_states[i].soil_water_mm = grid_.patches()[i].soil.water_capacity_mm;
    }
    now_.stems_at_start = stems_standing();
    now_.mass_at_start_kg = mass_standing_kg();
}

Stand::Stand(PatchGrid grid, std::size_t species_count, StandImage image)
    : grid_{std::move(grid)}, species_count_{species_count}, now_{std::move(image)} {
    assert(now_.patch_states.size() == grid_.size());
}

std::optional<std::size_t> Stand::find(TreeId id) const {
    const auto found = std::lower_bound(now_.trees.begin(), now_.trees.end(), id,
                                        [](const Tree& tree, TreeId wanted) { return tree.id < wanted; });
    if (found == now_.trees.end() || found->id != id) {
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - now_.trees.begin());
}

std::span<const Wound> Stand::wounds_of(TreeId id) const {
    const auto first = std::lower_bound(now_.wounds.begin(), now_.wounds.end(), id,
                                        [](const Wound& wound, TreeId tree) { return wound.tree < tree; });
    const auto last =
        std::find_if(first, now_.wounds.end(), [id](const Wound& wound) { return wound.tree != id; });
    return {first, last};
}

StandBalance Stand::total_balance() const {
    StandBalance total = now_.earlier;
    total += now_.balance;
    return total;
}

std::uint64_t Stand::stems_standing() const {
    std::uint64_t stems = 0;
    for (const Tree& tree : now_.trees) {
        stems += tree.stems;
    }
    return stems;
}

double Stand::mass_standing_kg() const {
    double mass_kg = 0.0;
    for (const Tree& tree : now_.trees) {
        mass_kg += tree.stems * tree.above_ground_kg;
    }
    return mass_kg;
}

double Stand::stem_mass_standing_kg() const {
    double mass_kg = 0.0;
    for (const Tree& tree : now_.trees) {
        mass_kg += tree.stems * tree.stem_kg;
    }
    return mass_kg;
}

double Stand::dead_wood_kg() const {
    double sum_kg = 0.0;
    for (const Snag& snag : now_.dead_wood.snags) {
        sum_kg += mass_kg(snag);
    }
    for (const Log& log : now_.dead_wood.logs) {
        sum_kg += mass_kg(log);
    }
    return sum_kg;
}

std::uint64_t Stand::saplings_standing() const {
    std::uint64_t saplings = 0;
    for (const Cohort& cohort : now_.cohorts) {
        saplings += cohort.stems;
    }
    return saplings;
}

void Stand::begin_year() {
    ++now_.year;
    now_.earlier += now_.balance;
    now_.balance = {};
    now_.deaths.clear();
}

void Stand::grow(std::span<const TreeGrowth> growth) {
    assert(growth.size() == now_.trees.size());
    for (std::size_t i = 0; i < now_.trees.size(); ++i) {
        Tree& tree = now_.trees[i];
        const TreeGrowth& year = growth[i];
        assert(year.dbh_cm >= 0.0 && year.height_m >= 0.0 && year.above_ground_kg > 0.0);
        assert(year.crown.base_m >= tree.crown.base_m && year.crown.base_m < tree.height_m + year.height_m);
        tree.dbh_cm += year.dbh_cm;
        tree.height_m += year.height_m;
        tree.age_years += 1.0;
        tree.crown = year.crown;
        tree.increments_cm = {year.dbh_cm, tree.increments_cm[0], tree.increments_cm[1]};
        now_.balance.grown_kg += tree.stems * year.gain_kg;
        now_.balance.shed_kg += tree.stems * (year.gain_kg - (year.above_ground_kg - tree.above_ground_kg));
        tree.above_ground_kg = year.above_ground_kg;
        now_.balance.stem_grown_kg += tree.stems * (year.stem_kg - tree.stem_kg);
        tree.stem_kg = year.stem_kg;
    }
}

void Stand::set_light_ratios(std::span<const double> light_ratios) {
    assert(light_ratios.size() == now_.trees.size());
    for (std::size_t i = 0; i < now_.trees.size(); ++i) {
        assert(light_ratios[i] >= 0.0 && light_ratios[i] <= 1.0);
        now_.trees[i].light_ratio = light_ratios[i];
    }
}

void Stand::set_stress_years(std::span<const std::uint16_t> stress_years) {
    assert(stress_years.size() == now_.trees.size());
    for (std::size_t i = 0; i < now_.trees.size(); ++i) {
        now_.trees[i].stress_years = stress_years[i];
    }
}

void Stand::set_vitalities(std::span<const double> vitalities) {
    assert(vitalities.size() == now_.trees.size());
    for (std::size_t i = 0; i < now_.trees.size(); ++i) {
        assert(vitalities[i] >= 0.0 && vitalities[i] <= 1.0);
        now_.trees[i].vitality = vitalities[i];
    }
}

void Stand::set_rots(std::span<const Rot> rots) {
    assert(rots.size() == now_.trees.size());
    for (std::size_t i = 0; i < now_.trees.size(); ++i) {
        now_.trees[i].rot = rots[i];
    }
}

void Stand::set_flags(TreeId tree, TreeFlags flags) {
    const std::optional<std::size_t> place = find(tree);
    assert(place.has_value());
    now_.trees[*place].flags = flags;
}

void Stand::set_patch_states(std::span<const PatchState> states) {
    assert(states.size() == now_.patch_states.size());
    std::copy(states.begin(), states.end(), now_.patch_states.begin());
}

void Stand::enter(Tree tree) {
    const std::optional<PatchId> patch = grid_.at(tree.x_m, tree.y_m);
    assert(patch.has_value() && index_of(tree.species) < species_count_ && tree.stems > 0);
    tree.patch = *patch;
    tree.id = TreeId{now_.next_id++};
    now_.trees.push_back(tree);
}

void Stand::add_trees(std::span<const Tree> trees) {
    for (const Tree& tree : trees) {
        now_.balance.stems_in[static_cast<std::size_t>(tree.origin)] += tree.stems;
        now_.balance.mass_in_kg += tree.stems * tree.above_ground_kg;
        now_.balance.stem_in_kg += tree.stems * tree.stem_kg;
        enter(tree);
    }
}

void Stand::remove_trees(std::span<const Removal> removals) {
    bool any_left = false;
    for (const Removal& removal : removals) {
        const std::optional<std::size_t> place = find(removal.tree);
        assert(place.has_value());
        Tree& tree = now_.trees[*place];
        if (tree.stems == 0) {
            continue;  // left for another cause
        }
        DeadTree dead{tree, removal.cause};
        dead.tree.stems = removal.stems == 0 ? tree.stems : std::min(removal.stems, tree.stems);
        tree.stems -= dead.tree.stems;
        any_left = any_left || tree.stems == 0;
        now_.balance.stems_out[index_of(removal.cause)] += dead.tree.stems;
        now_.balance.lost_kg[index_of(removal.cause)] += dead.tree.stems * dead.tree.above_ground_kg;
        now_.balance.stem_lost_kg[index_of(removal.cause)] += dead.tree.stems * dead.tree.stem_kg;
        now_.deaths.push_back(dead);
    }
    if (any_left) {
        std::erase_if(now_.trees, [](const Tree& tree) { return tree.stems == 0; });
        drop_wounds_of_the_dead();
    }
}

void Stand::split_groups(double dbh_cm, std::uint64_t seed, std::uint32_t replicate) {
    const std::size_t before = now_.trees.size();
    for (std::size_t i = 0; i < before; ++i) {
        if (now_.trees[i].stems == 1 || now_.trees[i].dbh_cm < dbh_cm) {
            continue;
        }
        Tree single = now_.trees[i];
        single.stems = 1;
        const config::Cell cell = grid_[single.patch].cell;
        for (std::uint32_t stem = 1; stem < now_.trees[i].stems; ++stem) {
            config::RandomStream stream{
                {seed, replicate, static_cast<std::uint16_t>(now_.year), now_.next_id},
                config::Purpose::tree_place};
            // Never quite the patch's edge: a place on it may belong to the neighbour.
            const auto along_side = [&stream] { return 0.01 + 0.98 * stream.uniform(); };
            single.x_m = grid_.frame().x_centre_m(cell.column) + (along_side() - 0.5) * patch_side_m;
            single.y_m = grid_.frame().y_centre_m(cell.row) + (along_side() - 0.5) * patch_side_m;
            enter(single);
        }
        now_.trees[i].stems = 1;
    }
}

void Stand::add_wounds(std::span<const Wound> wounds) {
    for (const Wound& wound : wounds) {
        if (find(wound.tree)) {
            now_.wounds.push_back(wound);
        }
    }
    std::stable_sort(now_.wounds.begin(), now_.wounds.end(), by_tree_and_height);
}

void Stand::set_wounds(std::vector<Wound> wounds) {
    now_.wounds = std::move(wounds);
    std::stable_sort(now_.wounds.begin(), now_.wounds.end(), by_tree_and_height);
    drop_wounds_of_the_dead();
}

void Stand::drop_wounds_of_the_dead() {
    auto tree = now_.trees.cbegin();
    std::erase_if(now_.wounds, [&](const Wound& wound) {
        while (tree != now_.trees.cend() && tree->id < wound.tree) {
            ++tree;
        }
        return tree == now_.trees.cend() || tree->id != wound.tree;
    });
}

void Stand::add_cohorts(std::span<const Cohort> cohorts) {
    for (const Cohort& cohort : cohorts) {
        assert(cohort.stems > 0 && cohort.height_m > 0.0 && index_of(cohort.patch) < grid_.size());
        now_.balance.saplings_in += cohort.stems;
        now_.cohorts.push_back(cohort);
    }
}

void Stand::grow_cohorts(std::span<const CohortGrowth> growth) {
    assert(growth.size() == now_.cohorts.size());
    for (std::size_t i = 0; i < now_.cohorts.size(); ++i) {
        now_.cohorts[i].height_m = growth[i].height_m;
        now_.cohorts[i].stress_years = growth[i].stress_years;
        now_.cohorts[i].browsed = growth[i].browsed;
        ++now_.cohorts[i].age_years;
        if (now_.cohorts[i].guarded_years > 0) {
            --now_.cohorts[i].guarded_years;
        }
    }
}

void Stand::remove_saplings(std::span<const SaplingRemoval> removals) {
    for (const SaplingRemoval& removal : removals) {
        Cohort& cohort = now_.cohorts[removal.cohort];
        const std::uint32_t stems = std::min(removal.stems, cohort.stems);
        cohort.stems -= stems;
        now_.balance.saplings_out[index_of(removal.cause)] += stems;
    }
    std::erase_if(now_.cohorts, [](const Cohort& cohort) { return cohort.stems == 0; });
}

void Stand::recruit(std::span<const std::size_t> cohorts, std::span<const Tree> trees) {
    assert(cohorts.size() == trees.size());
    for (std::size_t i = 0; i < cohorts.size(); ++i) {
        Cohort& cohort = now_.cohorts[cohorts[i]];
        assert(trees[i].stems == cohort.stems);
        now_.balance.saplings_recruited += cohort.stems;
        cohort.stems = 0;
    }
    std::erase_if(now_.cohorts, [](const Cohort& cohort) { return cohort.stems == 0; });
    add_trees(trees);
}

void Stand::begin_with(SnagsAndLogs dead_wood) {
    assert(now_.dead_wood.snags.empty() && now_.dead_wood.logs.empty());
    now_.dead_wood = std::move(dead_wood);
    now_.dead_wood_at_start_kg = dead_wood_kg();
}

void Stand::add_snags(std::span<const Snag> snags) {
    for (const Snag& snag : snags) {
        now_.balance.dead_wood_in_kg += mass_kg(snag);
    }
    now_.dead_wood.snags.insert(now_.dead_wood.snags.end(), snags.begin(), snags.end());
}

void Stand::add_logs(std::span<const Log> logs) {
    for (const Log& log : logs) {
        now_.balance.dead_wood_in_kg += mass_kg(log);
    }
    now_.dead_wood.logs.insert(now_.dead_wood.logs.end(), logs.begin(), logs.end());
}

void Stand::set_dead_wood(SnagsAndLogs dead_wood, const DeadWoodLoss& loss) {
    now_.balance.dead_wood_decayed_kg += loss.decayed_kg;
    now_.balance.dead_wood_to_soil_kg += loss.soil_kg;
    now_.balance.dead_wood_taken_kg += loss.taken_kg;
    now_.dead_wood = std::move(dead_wood);
}

}  // namespace forest
