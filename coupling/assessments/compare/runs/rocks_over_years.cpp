#include "coupling/assessments/compare/runs/rocks_over_years.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "coupling/assessments/compare/runs/means_over_years.hpp"
#include "coupling/assessments/compare/runs/rate_columns.hpp"
#include "coupling/assessments/compare/runs/run_tables.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/figures/ratio_parts.hpp"

namespace coupling::compare {
namespace {

namespace fs = std::filesystem;

/// Protection at a target in a year, replicate by replicate.
struct ProtectionInYear {
    std::vector<std::string> replicates;
    std::vector<double> percent;
    std::vector<double> reached_bare;
};

/// As on the page of the run: of a year the ratio of the rocks of all replicates together, and only years in
/// which enough of them arrive over the bare slope.
void add_year(const FigureKey& key, ProtectionInYear year, MeansOverYears& means) {
    const double bare = std::accumulate(year.reached_bare.begin(), year.reached_bare.end(), 0.0);
    const bool too_few = too_few_for_protection(static_cast<std::uint64_t>(bare));
    for (std::size_t i = 0; i < year.percent.size(); ++i) {
        if (std::isnan(year.percent[i])) {
            year.percent[i] = 0.0;  // without an arrival: of no weight
        }
    }
    const std::vector<double> parts =
        too_few ? std::vector(year.percent.size(), std::numeric_limits<double>::quiet_NaN())
                : parts_of_ratio(year.percent, year.reached_bare);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        means.add(key, year.replicates[i], parts[i],
                  "in every year too few rocks arrive over the bare slope for a protection figure");
    }
}

void add_protection_over_years(const fs::path& folder, MeansOverYears& means) {
    const config::Table table =
        read_table(folder, "protection.csv",
                   {"regime", "replicate", "year", "target_id", "reached_bare", "protection_percent"});
    std::vector<std::pair<FigureKey, std::map<std::string, ProtectionInYear>>> figures;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const FigureKey key{table.text(row, "target_id"), table.text(row, "regime"), "protection_percent",
                            over_years, climate_of(table, row)};
        auto found =
            std::find_if(figures.begin(), figures.end(), [&](const auto& each) { return each.first == key; });
        if (found == figures.end()) {
            found = figures.insert(figures.end(), {key, {}});
        }
        ProtectionInYear& year = found->second[table.text(row, "year")];
        year.replicates.push_back(table.text(row, "replicate"));
        year.percent.push_back(number(table, row, "protection_percent"));
        year.reached_bare.push_back(count(table, row, "reached_bare"));
    }
    for (auto& [key, years] : figures) {
        for (auto& [name, year] : years) {
            add_year(key, std::move(year), means);
        }
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
