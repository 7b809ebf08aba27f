#include "coupling/assessments/compare/runs/finished_run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

#include "config/errors/input_error.hpp"
#include "config/table/table.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/assessments/compare/runs/forest_over_years.hpp"
#include "coupling/assessments/compare/runs/rate_columns.hpp"
#include "coupling/assessments/compare/runs/rocks_over_years.hpp"
#include "coupling/assessments/compare/runs/run_tables.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/few_rocks.hpp"
#include "coupling/results/figures/finished_runs.hpp"

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
    const auto bare = static_cast<std::uint64_t>(count(table, row, "reached_bare"));
    const Figure figure = with_interval(key, table, row, "protection_percent", "protection_low_percent",
                                        "protection_high_percent");
    return too_few_for_protection(bare) || says_nothing(figure.low, figure.high)
               ? Figure{.key = key, .why_none = too_few_in_words(bare)}
               : figure;
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
    constexpr std::array needed{
        Needed{"design_class", "design_class", ""}, Needed{"design_energy_kj", "design_energy", "_kj"},
        Needed{"design_height_m", "design_height", "_m"}, Needed{"sold_height_m", "sold_height", "_m"}};
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

void add_worst_years(const fs::path& folder, std::vector<Figure>& figures) {
    const config::Table table = read_table(
        folder, "regimes_worst_year.csv",
        {"regime", "target_id", "quantity", "year", "replicates", "mean", "mean_low_90", "mean_high_90"});
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const bool has_range = number(table, row, "replicates") > 1.0;
        figures.push_back(
            {.key = {table.text(row, "target_id"), table.text(row, "regime"), table.text(row, "quantity"),
                     worst_year, climate_of(table, row)},
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
    if (path_exists(folder / "summary.json")) {
        return;
    }
    if (path_exists(folder / "parts")) {
        config::fail(config::ExitCode::file, {folder.string()}, "only parts of a run that is not finished",
                     "finished results: run the same command again to go on");
    }
    config::fail(config::ExitCode::file, {folder.string()}, "no results in this folder",
                 "the --out folder of a finished run, with summary.json", name_a_finished_run(folder));
}

}  // namespace

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
        const std::vector<fs::path> beside = finished_runs_in(folder.parent_path());
        config::fail(config::ExitCode::settings, {folder.string()}, "a hazard map of several return periods",
                     "the folder of one of them",
                     beside.empty() ? "" : config::joined("such as ", beside.back().string()));
    }
    if (run.summary.kind == "collapse") {
        config::fail(config::ExitCode::settings, {folder.string()}, "a run of `bannwald collapse`",
                     "runs of `bannwald run`: a collapse has no figures of rocks at targets to compare",
                     "compare their tables/energies.csv");
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
