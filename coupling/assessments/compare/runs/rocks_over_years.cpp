#include "coupling/assessments/compare/runs/rocks_over_years.hpp"

#include <cstdint>
#include <limits>
#include <map>
#include <tuple>

#include "coupling/assessments/compare/runs/means_over_years.hpp"
#include "coupling/assessments/compare/runs/rate_columns.hpp"
#include "coupling/assessments/compare/runs/run_tables.hpp"
#include "coupling/results/figures/few_rocks.hpp"

namespace coupling::compare {
namespace {

namespace fs = std::filesystem;

/// As on the page of the run: only years in which enough rocks arrive over the bare slope, all replicates of
/// a regime in a climate together.
void add_protection_over_years(const fs::path& folder, MeansOverYears& means) {
    const config::Table table =
        read_table(folder, "protection.csv",
                   {"regime", "replicate", "year", "target_id", "reached_bare", "protection_percent"});
    const auto key_of = [&](std::size_t row) {
        return FigureKey{table.text(row, "target_id"), table.text(row, "regime"), "protection_percent",
                         over_years, climate_of(table, row)};
    };
    const auto place_of = [&](std::size_t row) {
        const FigureKey key = key_of(row);
        return std::tuple{key.target, key.regime, key.climate, table.text(row, "year")};
    };
    std::map<std::tuple<std::string, std::string, std::string, std::string>, std::uint64_t> bare;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        bare[place_of(row)] += static_cast<std::uint64_t>(count(table, row, "reached_bare"));
    }
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const bool too_few = too_few_for_protection(bare[place_of(row)]);
        means.add(
            key_of(row), table.text(row, "replicate"),
            too_few ? std::numeric_limits<double>::quiet_NaN() : number(table, row, "protection_percent"),
            "in every year too few rocks arrive over the bare slope for a protection figure");
    }
}

}  // namespace

void add_targets_over_years(const fs::path& folder, std::vector<Figure>& figures) {
    MeansOverYears means{figures};
    add_protection_over_years(folder, means);
    const config::Table targets = read_table(folder, "targets.csv",
                                             {"regime", "replicate", "target_id", "cover", "share_percent",
                                              "energy_50_kj", "energy_95_kj", "energy_99_kj"});
    for (std::size_t row = 0; row < targets.rows(); ++row) {
        const bool bare = targets.text(row, "cover") == "bare";
        const auto add = [&](const std::string& quantity, const std::string& column) {
            means.add({targets.text(row, "target_id"), targets.text(row, "regime"), quantity, over_years,
                       climate_of(targets, row)},
                      targets.text(row, "replicate"), number(targets, row, column));
        };
        add(bare ? "reached_bare_percent" : "reached_percent", "share_percent");
        for (const RateColumn& rate : rate_columns(targets, {})) {
            add(rate.with(bare ? "_bare" : ""), rate.with(""));
        }
        if (!bare) {
            add("energy_50_kj", "energy_50_kj");
            add("energy_95_kj", "energy_95_kj");
            add("energy_99_kj", "energy_99_kj");
        }
    }
    means.finish();
}

}  // namespace coupling::compare
