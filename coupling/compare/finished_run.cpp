#include "coupling/compare/finished_run.hpp"

#include <algorithm>
#include <array>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <tuple>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/table/table.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/compare/run_tables.hpp"
#include "coupling/inputs/file_bytes.hpp"
#include "coupling/inputs/path_checks.hpp"
#include "coupling/inputs/scenario.hpp"
#include "coupling/results/effect_words.hpp"
#include "coupling/results/few_rocks.hpp"

namespace coupling::compare {
namespace {

using config::joined;

namespace fs = std::filesystem;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// A figure whose interval stands beside it.
Figure with_interval(FigureKey key, const config::Table& table, std::size_t row, const std::string& value,
                     const std::string& low, const std::string& high) {
    return {.key = std::move(key),
            .value = number(table, row, value),
            .low = low.empty() ? unknown : number(table, row, low),
            .high = high.empty() ? unknown : number(table, row, high),
            .is_interval = true};
}

/// As on the page of the run: none from too few rocks.
Figure protection_today(const config::Table& table, std::size_t row) {
    const FigureKey key{table.text(row, "target_id"), "", "protection_percent", "today"};
    const auto bare = static_cast<std::uint64_t>(number(table, row, "reached_bare"));
    return too_few_for_protection(bare) ? Figure{.key = key, .why_none = too_few_in_words(bare)}
                                        : with_interval(key, table, row, "protection_percent",
                                                        "protection_low_percent", "protection_high_percent");
}

/// Columns and figures of rocks above an energy: "above_300_kj" + "_bare" + "_per_1000".
struct RateColumn {
    std::string begin;
    [[nodiscard]] std::string with(const std::string& infix) const {
        return joined(begin, infix, "_per_1000");
    }
};

/// Those that a table has; runs of earlier versions have none. Throws config::InputError (data) for one that
/// lacks one of its `wanted` columns.
std::vector<RateColumn> rate_columns(const config::Table& table, const std::vector<std::string>& wanted) {
    std::vector<RateColumn> columns;
    config::Problems problems;
    for (std::size_t i = 0; i < rockfall::counted_energies_j.size(); ++i) {
        const RateColumn rate{joined("above_", kj_text(i), "_kj")};
        if (table.has(rate.with(""))) {
            for (const std::string& infix : wanted) {
                table.require({rate.with(infix)}, problems);
            }
            columns.push_back(rate);
        }
    }
    problems.throw_if_any();
    return columns;
}

void add_rates(const config::Table& table, std::size_t row, const std::string& where,
               const std::string& cover, std::vector<Figure>& figures) {
    for (const RateColumn& rate : rate_columns(table, {"_low", "_high"})) {
        figures.push_back(with_interval({where, "", rate.with(cover), "today"}, table, row, rate.with(""),
                                        rate.with("_low"), rate.with("_high")));
    }
}

void add_today(const fs::path& folder, std::vector<Figure>& figures) {
    if (!has_table(folder, "targets.csv")) {
        return;
    }
    if (has_table(folder, "protection.csv")) {
        const config::Table table = read_table(folder, "protection.csv",
                                               {"target_id", "reached_bare", "protection_percent",
                                                "protection_low_percent", "protection_high_percent"});
        for (std::size_t row = 0; row < table.rows(); ++row) {
            figures.push_back(protection_today(table, row));
        }
    }
    const config::Table table =
        read_table(folder, "targets.csv",
                   {"target_id", "cover", "share_percent", "share_low_percent", "share_high_percent",
                    "energy_50_kj", "energy_95_kj", "energy_95_low_kj", "energy_95_high_kj", "energy_99_kj"});
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string& target = table.text(row, "target_id");
        const std::string end = table.text(row, "cover") == "bare" ? "_bare" : "";
        const auto key = [&](const char* begin, const char* unit) {
            return FigureKey{target, "", joined(begin, end, unit), "today"};
        };
        figures.push_back(with_interval(key("reached", "_percent"), table, row, "share_percent",
                                        "share_low_percent", "share_high_percent"));
        figures.push_back(with_interval(key("energy_50", "_kj"), table, row, "energy_50_kj", "", ""));
        figures.push_back(with_interval(key("energy_95", "_kj"), table, row, "energy_95_kj",
                                        "energy_95_low_kj", "energy_95_high_kj"));
        figures.push_back(with_interval(key("energy_99", "_kj"), table, row, "energy_99_kj", "", ""));
        add_rates(table, row, target, end, figures);
    }
}

/// A figure of nets.csv; a class need not be a number ("none").
Figure net_figure(FigureKey key, const config::Table& table, std::size_t row, const std::string& column) {
    Figure figure{.key = std::move(key)};
    figure.value = config::parse_number(table.text(row, column)).value_or(unknown);
    return figure;
}

/// What nets hold and what they would need; columns that runs of earlier versions lack are left out.
void add_nets(const fs::path& folder, std::vector<Figure>& figures) {
    if (!has_table(folder, "nets.csv")) {
        return;
    }
    const config::Table table = read_table(
        folder, "nets.csv", {"net", "cover", "held_percent", "held_low_percent", "held_high_percent"});
    struct Needed {
        const char* column;
        const char* begin;
        const char* unit;
    };
    constexpr std::array needed{Needed{"class_needed", "class_needed", ""},
                                Needed{"energy_needed_kj", "energy_needed", "_kj"},
                                Needed{"height_needed_m", "height_needed", "_m"}};
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string net = joined("net ", table.text(row, "net"));
        const std::string end = table.text(row, "cover") == "bare" ? "_bare" : "";
        figures.push_back(with_interval({net, "", joined("held", end, "_percent"), "today"}, table, row,
                                        "held_percent", "held_low_percent", "held_high_percent"));
        for (const Needed& each : needed) {
            if (table.has(each.column)) {
                figures.push_back(net_figure({net, "", joined(each.begin, end, each.unit), "today"}, table,
                                             row, each.column));
            }
        }
    }
}

void add_profile(const fs::path& folder, std::vector<Figure>& figures) {
    const config::Table table =
        read_table(folder, "stations.csv",
                   {"station", "reached_percent", "reached_low_percent", "reached_high_percent",
                    "energy_50_kj", "energy_95_kj", "energy_99_kj"});
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string& station = table.text(row, "station");
        figures.push_back(with_interval({station, "", "reached_percent", "today"}, table, row,
                                        "reached_percent", "reached_low_percent", "reached_high_percent"));
        for (const char* column : {"energy_50_kj", "energy_95_kj", "energy_99_kj"}) {
            figures.push_back(with_interval({station, "", column, "today"}, table, row, column, "", ""));
        }
        add_rates(table, row, station, "", figures);
    }
}

/// Sums over the years of each member in which a figure is known, in the order in which regimes come.
class MeansOverYears {
public:
    explicit MeansOverYears(std::vector<Figure>& figures) : figures_{figures} {}

    /// `why_none`: said of a figure that no year knows.
    void add(const FigureKey& key, const std::string& replicate, double value,
             const std::string& why_none = "") {
        auto found =
            std::find_if(sums_.begin(), sums_.end(), [&](const auto& sum) { return sum.first == key; });
        if (found == sums_.end()) {
            found = sums_.insert(sums_.end(), {key, {}});
        }
        if (std::isnan(value)) {
            why_none_.try_emplace(found - sums_.begin(), why_none);
            return;
        }
        auto& [sum, count] = found->second[config::parse_whole(replicate).value_or(0)];
        sum += value;
        ++count;
    }
    void finish() {
        for (std::size_t i = 0; i < sums_.size(); ++i) {
            auto& [key, replicates] = sums_[i];
            std::map<long long, double> means;
            for (const auto& [replicate, sum] : replicates) {
                means[replicate] = sum.first / static_cast<double>(sum.second);
            }
            figures_.push_back(over_replicates(key, std::move(means)));
            if (std::isnan(figures_.back().value)) {
                figures_.back().why_none = why_none_[static_cast<std::ptrdiff_t>(i)];
            }
        }
        sums_.clear();
        why_none_.clear();
    }

private:
    std::vector<Figure>& figures_;
    std::vector<std::pair<FigureKey, std::map<long long, std::pair<double, std::size_t>>>> sums_;
    std::map<std::ptrdiff_t, std::string> why_none_;  ///< by place in sums_
};

constexpr const char* over_years = "mean over years";

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
        bare[place_of(row)] += static_cast<std::uint64_t>(number(table, row, "reached_bare"));
    }
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const bool too_few = too_few_for_protection(bare[place_of(row)]);
        means.add(key_of(row), table.text(row, "replicate"),
                  too_few ? unknown : number(table, row, "protection_percent"),
                  "in every year too few rocks arrive over the bare slope for a protection figure");
    }
}

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

/// Timber and money; the work of the start counts in the first year.
void add_work_over_years(const fs::path& folder, std::uint32_t years, MeansOverYears& means) {
    static const std::vector<std::string> figures{"felled_m3pha", "salvaged_m3pha", "removed_m3pha",
                                                  "left_m3pha", "contribution_margin_eur_pha"};
    std::vector<std::string> columns{"regime", "replicate"};
    columns.insert(columns.end(), figures.begin(), figures.end());
    const config::Table table = read_table(folder, "work_by_year.csv", columns);
    std::map<std::tuple<std::string, std::string, std::string>, std::map<std::string, double>> sums;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        auto& sum = sums[{table.text(row, "regime"), climate_of(table, row), table.text(row, "replicate")}];
        for (const std::string& figure : figures) {
            sum[figure] += number(table, row, figure);
        }
    }
    for (const std::string& figure : figures) {
        for (const auto& [member, sum] : sums) {
            const auto& [regime, climate, replicate] = member;
            means.add({"", regime, figure, over_years, climate}, replicate,
                      sum.at(figure) / static_cast<double>(years));
        }
    }
}

void add_forest_over_years(const fs::path& folder, std::uint32_t years, std::vector<Figure>& figures) {
    MeansOverYears means{figures};
    const config::Table stands =
        read_table(folder, "stands.csv",
                   {"regime", "replicate", "year", "stand", "species", "basal_area_m2pha", "volume_m3pha"});
    for (std::size_t row = 0; row < stands.rows(); ++row) {
        if (stands.text(row, "stand") != "all" || stands.text(row, "species") != "all") {
            continue;
        }
        const std::string& regime = stands.text(row, "regime");
        const std::string climate = climate_of(stands, row);
        const std::string& replicate = stands.text(row, "replicate");
        means.add({"", regime, "basal_area_m2pha", over_years, climate}, replicate,
                  number(stands, row, "basal_area_m2pha"));
        means.add({"", regime, "volume_m3pha", over_years, climate}, replicate,
                  number(stands, row, "volume_m3pha"));
    }
    add_work_over_years(folder, years, means);
    means.finish();
}

void add_worst_years(const fs::path& folder, std::vector<Figure>& figures) {
    const config::Table table = read_table(
        folder, "regimes_worst_year.csv",
        {"regime", "target_id", "quantity", "year", "replicates", "mean", "mean_low_90", "mean_high_90"});
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const bool has_range = number(table, row, "replicates") > 1.0;
        figures.push_back(
            {.key = {table.text(row, "target_id"), table.text(row, "regime"), table.text(row, "quantity"),
                     "worst year", climate_of(table, row)},
             .value = number(table, row, "mean"),
             .low = has_range ? number(table, row, "mean_low_90") : unknown,
             .high = has_range ? number(table, row, "mean_high_90") : unknown,
             .year = static_cast<int>(config::parse_whole(table.text(row, "year")).value_or(-1))});
    }
}

void refuse_unfinished(const fs::path& folder) {
    if (!is_folder(folder)) {
        config::fail(config::ExitCode::file, {folder.string()}, "no such folder",
                     "the folder of a finished run");
    }
    if (!path_exists(folder / "summary.json")) {
        const bool has_parts = path_exists(folder / "parts");
        config::fail(config::ExitCode::file, {folder.string()},
                     has_parts ? "only parts of a run that is not finished" : "no results in this folder",
                     has_parts ? "finished results: run the same command again to go on"
                               : "the --out folder of a finished run, with summary.json");
    }
}

}  // namespace

Figure over_replicates(FigureKey key, std::map<long long, double> by_replicate) {
    if (by_replicate.empty()) {
        return {.key = std::move(key), .value = unknown};
    }
    const auto n = static_cast<double>(by_replicate.size());
    double mean = 0.0;
    for (const auto& [replicate, value] : by_replicate) {
        mean += value / n;
    }
    Figure figure{.key = std::move(key), .value = mean, .is_interval = true};
    if (by_replicate.size() > 1) {
        double squares = 0.0;
        for (const auto& [replicate, value] : by_replicate) {
            squares += (value - mean) * (value - mean);
        }
        const double error = std::sqrt(squares / (n - 1.0) / n);
        // Equal values (no rock arrives, say) say nothing about chance: no interval rather than one of no
        // width.
        if (error > 1e-9 * std::abs(mean) && error > 0.0) {
            const double half = boost::math::quantile(boost::math::students_t{n - 1.0}, 0.975) * error;
            const std::string& quantity = figure.key.quantity;
            const bool is_share = quantity.ends_with("_percent");
            const bool may_be_negative = quantity.empty() || quantity.starts_with("protection") ||
                                         quantity.ends_with("_eur_pha");  // empty: a difference
            // What cannot be is left out of the interval.
            figure.low = may_be_negative ? mean - half : std::max(0.0, mean - half);
            figure.high = is_share ? std::min(100.0, mean + half) : mean + half;
        }
    }
    figure.by_replicate = std::move(by_replicate);
    return figure;
}

/// Runs of earlier versions call some settings otherwise.
void use_present_names(SummaryOfRun& summary) {
    Scenario scenario;
    config::Options options;
    declare(options, scenario);
    for (auto& setting : summary.settings) {
        setting.key = options.present_name(setting.key);
    }
}

FinishedRun read_finished_run(const fs::path& folder) {
    refuse_unfinished(folder);
    const fs::path file = folder / "summary.json";
    FinishedRun run{folder, read_summary(open_file(file, {}, "a summary").text(), file.string()), {}};
    use_present_names(run.summary);
    if (run.summary.kind == "hazard") {
        config::fail(config::ExitCode::settings, {folder.string()}, "a hazard map of several return periods",
                     "the folder of one of them, return_period_… beside it");
    }
    if (run.summary.kind == "today") {
        add_today(folder, run.figures);
        add_nets(folder, run.figures);
    } else if (run.summary.kind == "profile") {
        add_profile(folder, run.figures);
    } else {
        if (run.summary.rocks > 0 && has_table(folder, "protection.csv")) {
            add_targets_over_years(folder, run.figures);
        }
        add_forest_over_years(folder, run.summary.years, run.figures);
        add_worst_years(folder, run.figures);
    }
    return run;
}

}  // namespace coupling::compare
