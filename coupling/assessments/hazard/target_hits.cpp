#include "coupling/assessments/hazard/target_hits.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/compare/runs/run_tables.hpp"
#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/assessments/hazard/hits/arrival_rows.hpp"
#include "rockfall/tally/ensemble_tally.hpp"

namespace coupling::hazard {
namespace {

using config::joined;

std::size_t number_of_target(const std::string& id, const Site& site, const std::string& place) {
    const auto found = std::find_if(site.targets.begin(), site.targets.end(),
                                    [&](const rockfall::Target& target) { return target.id == id; });
    if (found == site.targets.end()) {
        config::fail(config::ExitCode::data, {place}, config::in_quotes(id), "a target of this scenario");
    }
    return static_cast<std::size_t>(found - site.targets.begin());
}

/// Of the energies that targets.csv counts the largest one up to `from_kj`; "" for all rocks.
std::string column_up_to(double from_kj) {
    std::string column;
    for (const float energy_j : rockfall::counted_energies_j) {
        const double energy_kj = static_cast<double>(energy_j) / config::j_per_kj;
        if (energy_kj <= from_kj) {
            column = joined("above_", config::to_text(energy_kj), "_kj_rocks");
        }
    }
    return column;
}

/// What targets.csv has: numbers, energies, and the bound where nothing else is known.
HitsOfTargets counted_hits(const config::Table& targets, const Site& site, const Matrix& matrix,
                           HazardEnergy energy, double rocks_of_row) {
    HitsOfTargets all(site.targets.size());
    const std::string percentile = joined("energy_", stem_of(energy).substr(2), "_kj");
    for (std::size_t row = 0; row < targets.rows(); ++row) {
        const std::size_t target =
            number_of_target(targets.text(row, "target_id"), site, targets.text(row, "target_id"));
        const Cover cover = targets.text(row, "cover") == name_of(Cover::bare) ? Cover::bare : Cover::forest;
        TargetHits& hits = all[target][index_of(cover)];
        hits.rocks = static_cast<std::uint64_t>(compare::count(targets, row, "reached"));
        if (hits.rocks == 0) {
            hits.rocks_above.assign(matrix.intensities(), 0);
            hits.even_rocks_above = hits.rocks_above;
            hits.at_place.per_release_above.assign(matrix.intensities(), 0.0);
            continue;
        }
        hits.largest_kj = compare::size(targets, row, "energy_max_kj");
        // Few rocks have no percentile. The largest of them stands for it, and is often lower.
        const double of_hits_kj = compare::number(targets, row, percentile);
        const bool is_largest = std::isnan(of_hits_kj);
        hits.at_place.energy = {is_largest ? hits.largest_kj : of_hits_kj, hits.rocks, is_largest};
        hits.at_place.per_release = static_cast<double>(hits.rocks) / rocks_of_row;
        for (const double from_kj : matrix.energy_from_kj()) {
            const std::string column = column_up_to(from_kj);
            const double counted =
                column.empty() ? static_cast<double>(hits.rocks) : compare::count(targets, row, column);
            const double above = hits.largest_kj < from_kj ? 0.0 : counted;
            hits.rocks_above.push_back(static_cast<std::uint64_t>(above));
            hits.at_place.per_release_above.push_back(above / rocks_of_row);
            hits.at_place.rocks_above.push_back(above);
        }
        hits.even_rocks_above = hits.rocks_above;  // all of one row
    }
    return all;
}

/// Row by row: there may be many millions.
void count_rows(const std::filesystem::path& file, const Site& site, const Matrix& matrix,
                const hits::BlockRows& blocks, HitsOfTargets& all) {
    HitsOfTargets found(all.size());
    const std::vector<double> none(matrix.intensities(), 0.0);
    std::vector<std::array<std::vector<double>, rockfall::covers>> squares(all.size(), {none, none});
    for (auto& covers : found) {
        for (TargetHits& hits : covers) {
            hits.rocks_above.assign(matrix.intensities(), 0);
            hits.at_place.per_release_above.assign(matrix.intensities(), 0.0);
        }
    }
    hits::for_each_arrival(file, site, blocks, [&](const hits::ArrivalRow& row) {
        TargetHits& of_target = found[row.target][index_of(row.cover)];
        const double weight = 1.0 / static_cast<double>(blocks.rows()[row.block_row].rocks);
        ++of_target.rocks;
        of_target.at_place.per_release += weight;
        const std::size_t intensity = matrix.intensity_of(row.energy_kj);
        for (std::size_t i = 0; i <= intensity; ++i) {
            ++of_target.rocks_above[i];
            of_target.at_place.per_release_above[i] += weight;
            squares[row.target][index_of(row.cover)][i] += weight * weight;
        }
    });
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t cover = 0; cover < rockfall::covers; ++cover) {
            TargetHits& hits = found[i][cover];
            if (hits.rocks != all[i][cover].rocks) {
                config::fail(config::ExitCode::data, {file.string()},
                             joined(std::to_string(hits.rocks), " rows for target ",
                                    config::in_quotes(site.targets[i].id)),
                             joined(std::to_string(all[i][cover].rocks), " as in targets.csv"),
                             "--overwrite to simulate this return period again");
            }
            hits.at_place.energy = all[i][cover].at_place.energy;
            hits.largest_kj = all[i][cover].largest_kj;
            for (std::size_t k = 0; k < matrix.intensities(); ++k) {
                hits.at_place.rocks_above.push_back(static_cast<double>(hits.rocks_above[k]));
                hits.even_rocks_above.push_back(
                    even_rocks(hits.at_place.per_release_above[k], squares[i][cover][k]));
            }
            all[i][cover] = std::move(hits);
        }
    }
}

}  // namespace

std::uint64_t even_rocks(double weights, double squares) {
    constexpr double rounding = 1e-6;  // of sums of many millions
    return squares > 0.0 ? static_cast<std::uint64_t>((1.0 + rounding) * weights * weights / squares) : 0;
}

HitsOfTargets hits_of(const std::filesystem::path& folder, const Site& site, const hits::BlockRows& blocks,
                      const Matrix& matrix, HazardEnergy energy) {
    if (site.targets.empty()) {
        return {};
    }
    const config::Table targets = compare::read_table(
        folder, "targets.csv", {"target_id", "cover", "rocks", "reached", "energy_max_kj"});
    HitsOfTargets all = counted_hits(targets, site, matrix, energy, blocks.fewest_rocks());
    if (compare::has_table(folder, "arrivals.csv")) {
        count_rows(folder / "tables" / "arrivals.csv", site, matrix, blocks, all);
    }
    return all;
}

}  // namespace coupling::hazard
