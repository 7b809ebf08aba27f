#include "coupling/results/figures/json.hpp"

#include <charconv>
#include <cmath>

#include "config/text/numbers.hpp"
#include "config/units/constants.hpp"
#include "config/version.hpp"
#include "coupling/inputs/scenario/scenario.hpp"

namespace coupling {
namespace {

using config::j_per_kj;
using config::percent;

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

Json inputs(const std::vector<InputFile>& files) {
    Json list = Json::array();
    for (const InputFile& file : files) {
        list.push_back(
            {{"role", file.role}, {"file", file.name}, {"hash", file.hash}, {"bytes", file.bytes}});
    }
    return list;
}

}  // namespace

Json json_number(double value) {
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

Json json_interval(const Interval& i, double factor) {
    return {json_number(factor * i.low), json_number(factor * i.high)};
}

Json json_share(const Share& s) {
    return {{"rocks", s.part},
            {"percent", json_number(percent * s.value)},
            {"interval_95_percent", json_interval(s.interval, percent)}};
}

Json json_distribution(const Distribution& d, bool with_interval) {
    Json json{{"mean", json_number(d.mean)}, {"p50", json_number(d.p50)}, {"p90", json_number(d.p90)},
              {"p95", json_number(d.p95)},   {"p98", json_number(d.p98)}, {"p99", json_number(d.p99)},
              {"max", json_number(d.max)}};
    if (with_interval && !std::isnan(d.mean)) {
        json["p95_interval_95"] = json_interval(d.p95_interval, 1.0);
    }
    return json;
}

Json json_above_energies(const std::array<Share, rockfall::counted_energies_j.size()>& above) {
    constexpr double per_1000 = 1000.0;
    Json list = Json::array();
    for (std::size_t i = 0; i < above.size(); ++i) {
        list.push_back(
            {{"above_kj", json_number(static_cast<double>(rockfall::counted_energies_j[i]) / j_per_kj)},
             {"rocks", above[i].part},
             {"per_1000_released", json_number(per_1000 * above[i].value)},
             {"interval_95_per_1000", json_interval(above[i].interval, per_1000)}});
    }
    return list;
}

Json json_map_frame(const config::GridFrame& frame) {
    return {{"columns", frame.columns},           {"rows", frame.rows},
            {"x_west_m", frame.x_west_m},         {"y_south_m", frame.y_south_m},
            {"cell_width_m", frame.cell_width_m}, {"cell_height_m", frame.cell_height_m}};
}

Json json_settings(const Scenario& scenario) {
    Json list = Json::array();
    for (const config::ParameterRow& row : scenario.shown_settings()) {
        list.push_back({{"key", row.key},
                        {"value", value_of(row)},
                        {"unit", row.unit},
                        {"default", row.default_text},
                        {"changed", row.changed}});
    }
    return list;
}

namespace {

void write_summary_of(std::ostream& out, Json summary, const std::vector<InputFile>& input_files,
                      const Scenario* scenario, const std::vector<WrittenFile>& files) {
    summary["commit"] = config::commit();
    if (scenario != nullptr) {
        summary["overrides"] = scenario->shown_overrides();
    }
    summary["inputs"] = inputs(input_files);
    if (scenario != nullptr) {
        summary["settings"] = json_settings(*scenario);
    }
    summary["files"] = Json::array();
    for (const WrittenFile& file : files) {
        summary["files"].push_back({{"path", file.path}, {"holds", file.sentence}});
    }
    // Names that are not UTF-8 are shown with a replacement sign instead of ending the run. Straight to the
    // file: the text of a village takes tens of megabytes.
    nlohmann::detail::serializer<Json> writer{nlohmann::detail::output_adapter<char>{out}, ' ',
                                              Json::error_handler_t::replace};
    writer.dump(summary, true, false, 2);
    out << '\n';
}

}  // namespace

void write_json_summary(std::ostream& out, Json summary, const std::vector<InputFile>& input_files,
                        const Scenario& scenario, const std::vector<WrittenFile>& files) {
    write_summary_of(out, std::move(summary), input_files, &scenario, files);
}

void write_json_summary(std::ostream& out, Json summary, const std::vector<InputFile>& input_files,
                        const std::vector<WrittenFile>& files) {
    write_summary_of(out, std::move(summary), input_files, nullptr, files);
}

}  // namespace coupling
