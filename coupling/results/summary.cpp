#include "coupling/results/summary.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "config/errors/input_error.hpp"
#include "config/text/numbers.hpp"
#include "config/units/constants.hpp"
#include "coupling/decades/decade_results.hpp"
#include "coupling/hazard/hazard_results.hpp"
#include "coupling/profile/profile_results.hpp"
#include "coupling/results/few_rocks.hpp"
#include "coupling/results/read_summary.hpp"

namespace coupling {
namespace {

using config::j_per_kj;
using config::percent;

using Json = nlohmann::ordered_json;

/// What is not known becomes null. Nine digits: the rest is noise of the last bit.
Json number(double value) {
    if (!std::isfinite(value)) {
        return nullptr;
    }
    std::array<char, 64> digits{};
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 9).ptr;
    double rounded = 0.0;
    std::from_chars(digits.data(), end, rounded);
    return rounded;
}

Json interval(const Interval& i, double factor) {
    return {number(factor * i.low), number(factor * i.high)};
}

Json share(const Share& s) {
    return {{"rocks", s.part},
            {"percent", number(percent * s.value)},
            {"interval_95_percent", interval(s.interval, percent)}};
}

Json distribution(const Distribution& d, bool with_interval) {
    Json json{{"mean", number(d.mean)}, {"p50", number(d.p50)}, {"p90", number(d.p90)},
              {"p95", number(d.p95)},   {"p98", number(d.p98)}, {"p99", number(d.p99)},
              {"max", number(d.max)}};
    if (with_interval && !std::isnan(d.mean)) {
        json["p95_interval_95"] = interval(d.p95_interval, 1.0);
    }
    return json;
}

/// Rocks with more than each counted energy, per 1000 released.
Json above_energies(const std::array<Share, rockfall::counted_energies_j.size()>& above) {
    constexpr double per_1000 = 1000.0;
    Json list = Json::array();
    for (std::size_t i = 0; i < above.size(); ++i) {
        list.push_back({{"above_kj", number(static_cast<double>(rockfall::counted_energies_j[i]) / j_per_kj)},
                        {"rocks", above[i].part},
                        {"per_1000_released", number(per_1000 * above[i].value)},
                        {"interval_95_per_1000", interval(above[i].interval, per_1000)}});
    }
    return list;
}

Json arrivals(const ArrivalFigures& figures) {
    return {{"reached", share(figures.share)},
            {"energy_kj", distribution(figures.energy_kj, true)},
            {"above_energies", above_energies(figures.above)},
            {"speed_mps", distribution(figures.speed_mps, true)},
            {"height_m", distribution(figures.height_m, true)}};
}

Json protection(const TargetFigures& target) {
    if (!target.protection) {
        return nullptr;
    }
    const ProtectionEffect& effect = *target.protection;
    Json json{{"effect_percent", number(percent * effect.value)},
              {"interval_95_percent", interval(effect.interval, percent)},
              {"interval_is_one_sided", effect.one_sided},
              {"too_few_rocks", too_few_for_protection(target.paired)},
              {"reached_both", target.paired.both},
              {"reached_only_bare", target.paired.only_bare},
              {"reached_only_forest", target.paired.only_forest}};
    if (!effect.one_sided) {
        json["rocks_for_half_interval"] = rocks_for_half(target.at(Cover::bare).share.whole);
    }
    if (target.reduction) {
        json["bari_percent"] = number(target.reduction->bari_percent);
        json["miri_percent"] = number(target.reduction->miri_percent);
        json["orpi_percent"] = number(target.reduction->orpi_percent);
    }
    return json;
}

Json targets(const Figures& figures, const std::vector<Cover>& covers) {
    Json list = Json::array();
    for (const TargetFigures& target : figures.targets) {
        Json json{{"id", target.id}, {"name", target.name}, {"kind", target.is_area ? "area" : "line"}};
        for (const Cover cover : covers) {
            json[name_of(cover)] = arrivals(target.at(cover));
        }
        json["protection"] = protection(target);
        list.push_back(std::move(json));
    }
    return list;
}

Json slope(const SlopeFigures& figures) {
    Json stops;
    for (std::size_t reason = 0; reason < figures.by_reason.size(); ++reason) {
        stops[name_of(static_cast<rockfall::StopReason>(reason))] = share(figures.by_reason[reason]);
    }
    return {{"rocks", figures.rocks},
            {"stop_reasons", stops},
            {"run_out_m", distribution(figures.run_out_m, false)},
            {"max_speed_mps", distribution(figures.max_speed_mps, true)},
            {"max_energy_kj", distribution(figures.max_energy_kj, true)},
            {"max_height_m", distribution(figures.max_height_m, true)},
            {"mean_speed_mps", number(figures.mean_speed_mps)},
            {"jump_height_mean_m", number(figures.jump_height_mean_m)},
            {"jumps_per_rock", number(figures.jumps_per_rock)},
            {"ground_impacts_per_rock", number(figures.ground_impacts_per_rock)},
            {"tree_hits_per_rock", number(figures.tree_hits_per_rock)},
            {"trees_broken_per_rock", number(figures.trees_broken_per_rock)},
            {"tree_energy_per_rock_kj", number(figures.tree_energy_per_rock_kj)},
            {"hit_a_tree", share(figures.hit_a_tree)},
            {"log_hits_per_rock", number(figures.log_hits_per_rock)},
            {"logs_broken_per_rock", number(figures.logs_broken_per_rock)},
            {"log_energy_per_rock_kj", number(figures.log_energy_per_rock_kj)}};
}

/// A value as its kind says: number, yes/no, or text.
Json value_of(const config::ParameterRow& row) {
    if (row.kind == "number" || row.kind == "whole number") {
        if (const auto whole = config::parse_whole(row.value_text)) {
            return *whole;
        }
    }
    if (row.kind == "number") {
        if (const auto value = config::parse_number(row.value_text)) {
            return *value;
        }
    }
    if (row.kind == "yes/no") {
        return row.value_text == "yes";
    }
    return row.value_text;
}

Json settings(const Scenario& scenario) {
    Json list = Json::array();
    if (scenario.options == nullptr) {
        return list;
    }
    for (const config::ParameterRow& row : scenario.options->rows()) {
        list.push_back({{"key", row.key},
                        {"value", value_of(row)},
                        {"unit", row.unit},
                        {"default", row.default_text},
                        {"changed", row.changed}});
    }
    return list;
}

Json inputs(const std::vector<InputFile>& files) {
    Json list = Json::array();
    for (const InputFile& file : files) {
        list.push_back(
            {{"role", file.role}, {"file", file.name}, {"hash", file.hash}, {"bytes", file.bytes}});
    }
    return list;
}

Json map_frame(const config::GridFrame& frame) {
    return {{"columns", frame.columns},           {"rows", frame.rows},
            {"x_west_m", frame.x_west_m},         {"y_south_m", frame.y_south_m},
            {"cell_width_m", frame.cell_width_m}, {"cell_height_m", frame.cell_height_m}};
}

Json run(const RunResults& results) {
    const Site& site = results.site;
    return {{"scenario", results.scenario.file.filename().string()},
            {"seed", results.scenario.seed},
            {"rocks", results.rocks},
            {"release_sources", site.sources.size()},
            {"trees", site.trees.size()},
            {"logs", site.logs.size()},
            {"nets", site.nets.size()},
            {"with_forest", results.with_forest},
            {"map", map_frame(site.map_frame)},
            {"projection", site.projection.empty() ? Json(nullptr) : Json(site.projection)}};
}

/// Ends a summary of any kind of run.
void write_with_sources(std::ostream& out, Json summary, const std::vector<InputFile>& input_files,
                        const Scenario& scenario, const std::vector<WrittenFile>& files) {
    summary["inputs"] = inputs(input_files);
    summary["settings"] = settings(scenario);
    summary["files"] = Json::array();
    for (const WrittenFile& file : files) {
        summary["files"].push_back({{"path", file.path}, {"holds", file.sentence}});
    }
    // Names that are not UTF-8 are shown with a replacement sign instead of ending the run.
    out << summary.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

Json moments(const profile::Moments& m, double unit) {
    return {{"mean", number(m.mean() / unit)},
            {"sd", number(m.deviation() / unit)},
            {"min", number(m.least() / unit)},
            {"max", number(m.most() / unit)}};
}

Json spread(const profile::Spread& s, const rockfall::LogBins& bins, double unit) {
    Json json = moments(s.moments, unit);
    json["p50"] = number(s.quantile(bins, 0.50) / unit);
    json["p90"] = number(s.quantile(bins, 0.90) / unit);
    json["p95"] = number(s.quantile(bins, 0.95) / unit);
    json["p99"] = number(s.quantile(bins, 0.99) / unit);
    return json;
}

Json along_profile(const profile::ProfileTally& tally) {
    using namespace rockfall;
    Json stops;
    for (std::size_t reason = 0; reason < tally.by_reason.size(); ++reason) {
        stops[name_of(static_cast<StopReason>(reason))] =
            share(share_of(tally.by_reason[reason], tally.rocks));
    }
    return {{"stop_reasons", stops},
            {"run_out_m", moments(tally.run_out_m, 1.0)},
            {"max_speed_mps", spread(tally.max_speed_mps, fine_speed_bins, 1.0)},
            {"max_energy_kj", spread(tally.max_energy_j, fine_energy_bins, j_per_kj)},
            {"max_height_m", spread(tally.max_height_m, fine_height_bins, 1.0)},
            {"mean_speed_mps", moments(tally.mean_speed_mps, 1.0)},
            {"ground_impacts_per_rock", moments(tally.ground_impacts, 1.0)},
            {"jump_length_m", moments(tally.jump_length_m, 1.0)}};
}

Json stations(const profile::ProfileResults& results) {
    using namespace rockfall;
    Json list = Json::array();
    for (std::size_t i = 0; i < results.site.stations.size(); ++i) {
        const profile::StationTally& tally = results.tally.stations[i];
        list.push_back({{"name", results.site.stations[i].name},
                        {"distance_m", number(results.site.stations[i].distance_m)},
                        {"reached", share(share_of(tally.energy_j.moments.count(), results.tally.rocks))},
                        {"energy_kj", spread(tally.energy_j, fine_energy_bins, j_per_kj)},
                        {"above_energies", above_energies(rates_of(tally, results.tally.rocks))},
                        {"translational_kj", moments(tally.translational_j, j_per_kj)},
                        {"speed_mps", spread(tally.speed_mps, fine_speed_bins, 1.0)},
                        {"height_m", spread(tally.height_m, fine_height_bins, 1.0)}});
    }
    return list;
}

}  // namespace

void write_summary(std::ostream& out, const RunResults& results, const Figures& figures,
                   const std::vector<WrittenFile>& files) {
    Json summary{{"program", "Bannwald"}, {"version", results.version}, {"run", run(results)}};
    const std::vector<Cover> covers = covers_of(results);
    summary["targets"] = targets(figures, covers);
    for (const Cover cover : covers) {
        summary["slopes"][name_of(cover)] = slope(figures.at(cover));
    }
    summary["warnings"] = results.warnings.sentences();
    write_with_sources(out, std::move(summary), results.site.inputs, results.scenario, files);
}

void profile::write_summary(std::ostream& out, const ProfileResults& results,
                            const std::vector<WrittenFile>& files) {
    const ProfileTally& tally = results.tally;
    Json summary{{"program", "Bannwald"}, {"version", results.version}};
    summary["run"] = {{"scenario", results.scenario.file.filename().string()},
                      {"kind", "profile"},
                      {"seed", results.scenario.seed},
                      {"rocks", tally.rocks},
                      {"from_m", number(results.site.first_m())},
                      {"to_m", number(results.site.last_m())},
                      {"start_m", number(results.site.start_m)}};
    summary["slope"] = along_profile(tally);
    summary["stations"] = stations(results);
    summary["warnings"] = results.warnings.sentences();
    write_with_sources(out, std::move(summary), results.site.inputs, results.scenario, files);
}

namespace {

Json stand(const decades::StandRow& row) {
    const forest::StandFigures& f = row.figures;
    return {{"stems_pha", number(f.stems_pha)},
            {"basal_area_m2pha", number(f.basal_area_m2pha)},
            {"volume_m3pha", number(f.volume_m3pha)},
            {"dominant_height_m", number(f.dominant_height_m)},
            {"leaf_area_index", number(f.leaf_area_index)}};
}

/// The whole forest at the start and at the end, and the targets in the first and last year with rocks.
Json member(const decades::DecadeResults& results, const decades::MemberYears& years) {
    Json json{{"regime", results.names.regimes[years.member.regime]},
              {"climate", results.names.climates[years.member.climate]},
              {"replicate", years.member.replicate + 1}};
    const auto last_year = static_cast<std::int32_t>(results.scenario.years);
    for (const decades::StandRow& row : years.stands) {
        if (row.unit == decades::all && row.species == decades::all &&
            (row.year == 0 || row.year == last_year)) {
            json[row.year == 0 ? "stand_at_start" : "stand_at_end"] = stand(row);
        }
    }
    json["targets"] = Json::array();
    for (const decades::TargetRow& row : years.targets) {
        if (row.year == years.targets.front().year || row.year == years.targets.back().year) {
            Json target{{"id", results.site.targets[row.target].id},
                        {"year", row.year},
                        {"rocks", row.bare.share.whole},
                        {"reached_bare", row.paired.bare()},
                        {"reached_forest", row.paired.forest()}};
            const auto effect = protection_effect(row.paired);
            target["protection_percent"] = effect ? number(percent * effect->value) : Json(nullptr);
            target["too_few_rocks"] = too_few_for_protection(row.paired);
            target["above_energies_bare"] = above_energies(row.bare.above);
            target["above_energies_forest"] = above_energies(row.forest.above);
            json["targets"].push_back(std::move(target));
        }
    }
    return json;
}

}  // namespace

void decades::write_summary(std::ostream& out, const DecadeResults& results,
                            const std::vector<WrittenFile>& files) {
    Json summary{{"program", "Bannwald"}, {"version", results.version}};
    const forest::PatchGrid& grid = results.site.forest->grid;
    summary["run"] = {{"scenario", results.scenario.file.filename().string()},
                      {"kind", "years"},
                      {"seed", results.scenario.seed},
                      {"years", results.scenario.years},
                      {"first_calendar_year", results.site.forest->first_year()},
                      {"regimes", results.names.regimes},
                      {"climates", results.names.climates},
                      {"replicates", results.scenario.forest.replicates},
                      {"rocks_a_year", results.rocks},
                      {"patches", grid.size()},
                      {"area_ha", number(grid.area_ha())},
                      {"map", map_frame(results.site.map_frame)},
                      {"patch_map", map_frame(grid.frame())}};
    summary["members"] = Json::array();
    for (const MemberYears& years : results.members) {
        summary["members"].push_back(member(results, years));
    }
    summary["warnings"] = results.warnings.sentences();
    write_with_sources(out, std::move(summary), results.site.inputs, results.scenario, files);
}

namespace {

Json target_hazard(const hazard::TargetHazard& target) {
    Json shares;
    for (std::size_t level = 0; level < hazard::levels; ++level) {
        shares[hazard::level_names[level]] = number(percent * target.levels[level]);
    }
    return {{"highest_level", hazard::level_name(target.highest())}, {"share_percent", shares}};
}

}  // namespace

void hazard::write_summary(std::ostream& out, const HazardResults& results,
                           const std::vector<WrittenFile>& files) {
    Json summary{{"program", "Bannwald"}, {"version", results.version}};
    std::uint64_t rocks = 0;
    Json periods = Json::array();
    for (const FinishedPeriod& period : results.periods) {
        rocks += period.rocks;
        periods.push_back({{"return_period_years", period.return_period_years},
                           {"folder", "../" + period.folder.filename().string()},
                           {"rocks", period.rocks},
                           {"smallest_diameter_m", number(period.diameters.smallest_m)},
                           {"largest_diameter_m", number(period.diameters.largest_m)}});
    }
    summary["run"] = {{"scenario", results.scenario.file.filename().string()},
                      {"kind", "hazard"},
                      {"seed", results.scenario.seed},
                      {"rocks", rocks},
                      {"map", map_frame(results.site.map_frame)}};
    summary["return_periods"] = std::move(periods);
    summary["targets"] = Json::array();
    for (std::size_t i = 0; i < results.site.targets.size(); ++i) {
        Json target{{"id", results.site.targets[i].id}, {"name", results.site.targets[i].name}};
        for (const SlopeHazard& slope : results.slopes) {
            target[name_of(slope.cover)] = target_hazard(slope.targets[i]);
        }
        summary["targets"].push_back(std::move(target));
    }
    summary["warnings"] = results.warnings.sentences();
    write_with_sources(out, std::move(summary), results.inputs, results.scenario, files);
}

SummaryOfRun read_summary(std::string_view text, const std::string& file) {
    try {
        const Json summary = Json::parse(text);
        if (summary.at("program") != "Bannwald") {
            config::fail(config::ExitCode::data, {file}, "a summary of another program", "one of bannwald");
        }
        const Json& run = summary.at("run");
        SummaryOfRun read;
        read.version = summary.at("version").get<std::string>();
        read.kind = run.value("kind", "today");
        read.seed = run.at("seed").get<std::uint64_t>();
        read.rocks = run.contains("rocks") ? run["rocks"].get<std::uint64_t>()
                                           : run.at("rocks_a_year").get<std::uint64_t>();
        read.years = run.value("years", 0U);
        read.replicates = run.value("replicates", 1U);
        for (const Json& setting : summary.at("settings")) {
            const Json& value = setting.at("value");
            read.settings.push_back({setting.at("key").get<std::string>(),
                                     value.is_string() ? value.get<std::string>() : value.dump(),
                                     setting.at("unit").get<std::string>()});
        }
        for (const Json& input : summary.at("inputs")) {
            read.inputs.push_back({input.at("role").get<std::string>(), input.at("file").get<std::string>(),
                                   input.at("hash").get<std::string>()});
        }
        read.warnings = summary.value("warnings", std::vector<std::string>{});
        return read;
    } catch (const Json::exception&) {
        config::fail(config::ExitCode::data, {file}, "no summary of a run",
                     "summary.json as `bannwald run` writes it");
    }
}

std::vector<std::string> files_in_summary(std::string_view text, const std::string& file) {
    try {
        std::vector<std::string> paths;
        const Json summary = Json::parse(text);
        for (const Json& entry : summary.at("files")) {
            paths.push_back(entry.at("path").get<std::string>());
        }
        return paths;
    } catch (const Json::exception&) {
        config::fail(config::ExitCode::data, {file}, "no summary of a run",
                     "summary.json as `bannwald run` writes it");
    }
}

}  // namespace coupling
