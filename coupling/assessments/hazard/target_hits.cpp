#include "coupling/assessments/hazard/target_hits.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/units/constants.hpp"
#include "coupling/assessments/compare/runs/run_tables.hpp"
#include "coupling/assessments/hazard/hazard_results.hpp"
#include "coupling/inputs/own_files/own_rows.hpp"
#include "rockfall/tally/ensemble_tally.hpp"

namespace coupling::hazard {
namespace {

using config::joined;
using rockfall::ReleaseSource;
using rockfall::StartLaw;

/// How many rocks each row of hazard.blocks released, by what its sources have in common.
class RocksOfRows {
public:
    explicit RocksOfRows(const Site& site) : sources_{site.sources} {
        for (const ReleaseSource& source : sources_) {
            rocks_[source.own_start.get()] += source.rocks;
        }
    }
    [[nodiscard]] double of(std::uint64_t rock) const {
        const auto after =
            std::upper_bound(sources_.begin(), sources_.end(), rock,
                             [](std::uint64_t r, const ReleaseSource& s) { return r < s.first_rock; });
        return after == sources_.begin() ? fewest() : of_row((after - 1)->own_start.get());
    }
    [[nodiscard]] double fewest() const {
        std::uint64_t fewest = std::numeric_limits<std::uint64_t>::max();
        for (const auto& [row, rocks] : rocks_) {
            fewest = rocks > 0 ? std::min(fewest, rocks) : fewest;
        }
        return static_cast<double>(fewest);
    }

private:
    [[nodiscard]] double of_row(const StartLaw* row) const { return static_cast<double>(rocks_.at(row)); }

    const std::vector<ReleaseSource>& sources_;
    std::map<const StartLaw*, std::uint64_t> rocks_;
};

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
            hits.at_place.per_release_above.assign(matrix.intensities(), 0.0);
            continue;
        }
        hits.largest_kj = compare::size(targets, row, "energy_max_kj");
        // Few rocks have no percentile: the largest of them is on the safe side.
        const double of_hits_kj = compare::number(targets, row, percentile);
        hits.at_place.energy_kj = std::isnan(of_hits_kj) ? hits.largest_kj : of_hits_kj;
        hits.at_place.per_release = static_cast<double>(hits.rocks) / rocks_of_row;
        for (const double from_kj : matrix.energy_from_kj()) {
            const std::string column = column_up_to(from_kj);
            const double counted =
                column.empty() ? static_cast<double>(hits.rocks) : compare::count(targets, row, column);
            const double above = hits.largest_kj < from_kj ? 0.0 : counted;
            hits.rocks_above.push_back(static_cast<std::uint64_t>(above));
            hits.at_place.per_release_above.push_back(above / rocks_of_row);
        }
    }
    return all;
}

double energy_in(std::string_view field, const OwnRows& rows) {
    std::string text{field};
    std::replace(text.begin(), text.end(), ',', '.');  // tables for Excel
    const std::optional<double> energy_kj = config::parse_number(text);
    if (!energy_kj) {
        rows.refuse("an energy that is no number");
    }
    return *energy_kj;
}

/// Row by row: there may be many millions.
void count_rows(const std::filesystem::path& file, const Site& site, const Matrix& matrix,
                const RocksOfRows& released, HitsOfTargets& all) {
    OwnRows rows{file, std::nullopt, config::ExitCode::data};
    const std::size_t rock_at = rows.column("rock");
    const std::size_t target_at = rows.column("target_id");
    const std::size_t cover_at = rows.column("cover");
    const std::size_t energy_at = rows.column("energy_kj");
    std::map<std::string, std::size_t, std::less<>> numbers;
    for (std::size_t i = 0; i < site.targets.size(); ++i) {
        numbers.emplace(site.targets[i].id, i);
    }
    HitsOfTargets found(all.size());
    for (auto& covers : found) {
        for (TargetHits& hits : covers) {
            hits.rocks_above.assign(matrix.intensities(), 0);
            hits.at_place.per_release_above.assign(matrix.intensities(), 0.0);
        }
    }
    while (rows.next()) {
        const auto target = numbers.find(rows.fields()[target_at]);
        const std::optional<double> rock = config::parse_number(std::string{rows.fields()[rock_at]});
        if (target == numbers.end() || !rock || *rock < 0.0) {
            rows.refuse("a rock or target that this scenario does not have");
        }
        const Cover cover = rows.fields()[cover_at] == name_of(Cover::bare) ? Cover::bare : Cover::forest;
        TargetHits& hits = found[target->second][index_of(cover)];
        const double weight = 1.0 / released.of(static_cast<std::uint64_t>(*rock));
        const double energy_kj = energy_in(rows.fields()[energy_at], rows);
        ++hits.rocks;
        hits.at_place.per_release += weight;
        const std::size_t intensity = matrix.intensity_of(energy_kj);
        for (std::size_t i = 0; i <= intensity; ++i) {
            ++hits.rocks_above[i];
            hits.at_place.per_release_above[i] += weight;
        }
    }
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
            hits.at_place.energy_kj = all[i][cover].at_place.energy_kj;
            hits.largest_kj = all[i][cover].largest_kj;
            all[i][cover] = std::move(hits);
        }
    }
}

}  // namespace

HitsOfTargets hits_of(const std::filesystem::path& folder, const Site& site, const Matrix& matrix,
                      HazardEnergy energy) {
    if (site.targets.empty()) {
        return {};
    }
    const RocksOfRows released{site};
    const config::Table targets = compare::read_table(
        folder, "targets.csv", {"target_id", "cover", "rocks", "reached", "energy_max_kj"});
    HitsOfTargets all = counted_hits(targets, site, matrix, energy, released.fewest());
    if (compare::has_table(folder, "arrivals.csv")) {
        count_rows(folder / "tables" / "arrivals.csv", site, matrix, released, all);
    }
    return all;
}

}  // namespace coupling::hazard
