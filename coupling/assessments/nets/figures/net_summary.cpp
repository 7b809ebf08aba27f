#include "coupling/assessments/nets/figures/net_summary.hpp"

#include "config/text/language.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/results/report/head_of_run.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling {
Json json_of(const NetQuantity& quantity) {
    return {{"mean", json_number(quantity.mean)},
            {"p95", json_number(quantity.p95.value)},
            {"p99", json_number(quantity.p99.value)},
            {"max", json_number(quantity.max)}};
}

namespace {

std::string setting_of(const PathsHead& head, std::string_view key) {
    const auto found = std::find_if(head.settings.begin(), head.settings.end(),
                                    [&](const auto& setting) { return setting.first == key; });
    return found == head.settings.end() ? "" : found->second;
}

}  // namespace

std::string title_with_period(const std::string& title, const PathsHead& head) {
    const auto years = config::parse_number(setting_of(head, "hazard.return_period_years"));
    return years && *years > 0.0 ? report::page_text("{title} (return period of {years} years)",
                                                     {{"title", title}, {"years", report::exact(*years)}})
                                 : title;
}

Json run_of_paths(const std::filesystem::path& run, const std::filesystem::path& nets,
                  const PathsHead& head) {
    const DesignMargins margins = margins_of(head.design);
    return {{"paths_of", run.filename().string()},
            {"nets", nets.filename().string()},
            {"seed", head.seed},
            {"rocks", head.rocks[index_of(Cover::bare)]},
            {"wanted_share", json_number(head.wanted_share)},
            {"design",
             {{"rule", setting_of(head, "design.rule")},
              {"percentile", json_number(head.design.percentile)},
              {"energy_factor", json_number(margins.energy_factor)},
              {"height_factor", json_number(margins.height_factor)},
              {"freeboard_m", json_number(margins.freeboard_m)}}}};
}

ReportSettings head_of(const std::filesystem::path& run) {
    const std::filesystem::path file = run / "summary.json";
    const FileBytes bytes = open_file(file, {file.string()}, "the summary of a finished run");
    return report::head_of_run(read_summary(bytes.text(), file.string()));
}

Json json_of(std::span<const NetRecord> nets, std::span<const NetFigures> figures) {
    Json list = Json::array();
    for (const NetFigures& of : figures) {
        Json net{{"name", nets[of.net].name},         {"slope", name_of(of.cover)},
                 {"reached", json_share(of.reached)}, {"energy_kj", json_of(of.energy_kj)},
                 {"height_m", json_of(of.height_m)},  {"inexact_rocks", of.inexact}};
        for (std::size_t i = 0; i < of.outcome.size(); ++i) {
            net[name_of(static_cast<rockfall::NetOutcome>(i))] = json_share(of.outcome[i]);
        }
        if (of.design) {
            net["design"] = {{"energy_kj", json_number(of.design->design_energy_kj)},
                             {"class", of.design->energy_class},
                             {"capacity_kj", json_number(of.design->capacity_kj)},
                             {"passage_m", json_number(of.design->design_height_m)},
                             {"height_m", json_number(of.design->height_m)},
                             {"held", json_share(of.design->held)}};
            if (const auto& spread = of.design->spread) {
                net["design"]["of_all"] = {{"percentile_energy_kj", json_interval(spread->energy_kj, 1.0)},
                                           {"percentile_height_m", json_interval(spread->height_m, 1.0)},
                                           {"upper_class", spread->at_upper_ends.energy_class},
                                           {"upper_height_m", json_number(spread->at_upper_ends.height_m)}};
            }
        }
        list.push_back(std::move(net));
    }
    return list;
}

std::optional<char> excel_decimal_of(const PathsHead& head) {
    if (setting_of(head, "output.csv") != "excel") {
        return std::nullopt;
    }
    const auto language = config::language_of(setting_of(head, "report.language"));
    return config::decimal_sign(language.value_or(config::Language::en));
}

}  // namespace coupling
