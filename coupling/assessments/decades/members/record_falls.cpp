#include "coupling/assessments/decades/members/record_falls.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "rockfall/tally/log_bins.hpp"

namespace coupling::decades {

namespace {

/// Arrivals by energy, in bins of a few percent.
void record_energies(const rockfall::TargetTally& target, std::array<std::size_t, 2> counted_as,
                     std::int32_t year, std::uint32_t number, MemberYears& kept) {
    for (const Cover cover : {Cover::forest, Cover::bare}) {
        std::array<std::uint32_t, rockfall::energy_bins.count()> rocks{};
        const auto which = counted_as[cover == Cover::forest ? 0 : 1];
        for (const rockfall::BinCounts::Filled& fine : target.by_cover[which].energy.filled()) {
            const auto energy = static_cast<float>(rockfall::fine_energy_bins.low_of(fine.bin));
            rocks[rockfall::energy_bins.bin_of(energy)] += static_cast<std::uint32_t>(fine.count);
        }
        for (std::size_t bin = 0; bin < rocks.size(); ++bin) {
            if (rocks[bin] > 0) {
                kept.energies.push_back({year, static_cast<std::uint16_t>(number),
                                         static_cast<std::uint16_t>(bin), static_cast<std::uint32_t>(cover),
                                         rocks[bin]});
            }
        }
    }
}

void record_stopping_places(const exchange::StoppingPlaces& stopping, std::int32_t year, MemberYears& kept) {
    for (std::uint32_t t = 0; t < stopping.bands.size(); ++t) {
        for (std::uint32_t band = 0; band < stopping.bands[t].size(); ++band) {
            if (const exchange::PlaceCounts& counts = stopping.bands[t][band]; !counts.empty()) {
                kept.bands.push_back({year, t, band, counts});
            }
        }
        if (stopping.without_tree[t] != 0) {
            kept.bands.push_back({year, t, all, {.spared = stopping.without_tree[t]}});
        }
    }
    kept.stopping_patches.resize(std::max(kept.stopping_patches.size(), stopping.patches.size()));
    for (std::size_t patch = 0; patch < stopping.patches.size(); ++patch) {
        kept.stopping_patches[patch].add(stopping.patches[patch]);
    }
}

}  // namespace

void record_falls(const exchange::YearFalls& falls, std::int32_t year, MemberYears& kept) {
    const auto bare = static_cast<std::size_t>(Cover::bare);
    // Without a single stem the slope with forest is the bare slope.
    const std::size_t forest = falls.with_forest ? static_cast<std::size_t>(Cover::forest) : bare;
    for (const auto& [cover, counted] : {std::pair{Cover::forest, forest}, std::pair{Cover::bare, bare}}) {
        kept.slopes.push_back({year, cover, figures_of(falls.tally.runs[counted])});
        for (const auto& [part, rocks] : falls.tally.runs[counted].left_over) {
            kept.departures.push_back({year, cover, part, rocks});
        }
    }
    const std::uint64_t rocks = falls.tally.runs[bare].rocks;
    for (std::uint32_t t = 0; t < falls.tally.targets.size(); ++t) {
        const rockfall::TargetTally& target = falls.tally.targets[t];
        TargetRow row;
        row.year = year;
        row.target = t;
        const std::uint64_t with = target.by_cover[forest].reached;
        const std::uint64_t without = target.by_cover[bare].reached;
        const std::uint64_t both = falls.with_forest ? target.reached_both : without;
        row.paired = {both, with - both, without - both};
        row.forest = figures_of(target.by_cover[forest], rocks);
        row.bare = figures_of(target.by_cover[bare], rocks);
        kept.targets.push_back(row);
        record_energies(target, {forest, bare}, year, t, kept);
        for (const auto* rocks_at :
             {falls.with_forest ? &falls.at_targets : &falls.at_targets_bare, &falls.at_targets_bare}) {
            const std::vector<exchange::RockAtTarget>& here = (*rocks_at)[t];
            kept.rocks_at_targets.insert(kept.rocks_at_targets.end(), here.begin(), here.end());
        }
    }
    for (std::uint32_t t = 0; t < falls.living.size(); ++t) {
        kept.living.push_back({year, t, falls.living[t]});
    }
    record_stopping_places(falls.stopping, year, kept);
}

void record_cells(const exchange::YearFalls& falls, std::int32_t year, MemberYears& kept) {
    const auto bare = static_cast<std::size_t>(Cover::bare);
    const std::size_t forest = falls.with_forest ? static_cast<std::size_t>(Cover::forest) : bare;
    for (const auto& [cover, number] : {std::pair{Cover::forest, forest}, {Cover::bare, bare}}) {
        const auto& cells = falls.tally.cells[number].cells;
        kept.maps.push_back({year, cover, {cells.begin(), cells.end()}});
    }
}

void record_paths(const exchange::YearFalls& falls, std::int32_t year, MemberYears& kept) {
    for (const rockfall::PathRecord& path : falls.paths) {
        for (const rockfall::PathPoint& point : path.points) {
            kept.paths.push_back({year, point.energy_j / 1000.0F, path.rock, point.position_m.x(),
                                  point.position_m.y(), point.position_m.z()});
        }
    }
}

}  // namespace coupling::decades
