#include "coupling/results/report/deciding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string_view>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/words_of_list.hpp"
#include "coupling/inputs/reading/guesses.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/figures/model_verdicts.hpp"
#include "coupling/results/report/listings.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/phrases.hpp"

namespace coupling::report {
namespace {

using config::joined;
using rockfall::ReleaseSource;
using rockfall::StartLaw;

bool was_set(const config::Options& options, const std::vector<std::string>& keys) {
    return std::any_of(keys.begin(), keys.end(),
                       [&](const std::string& key) { return options.was_set(key); });
}

bool has_guess(const config::Options& options, const std::vector<std::string>& keys) {
    return std::any_of(keys.begin(), keys.end(),
                       [&](const std::string& key) { return is_guess(options, key); });
}

/// Not set, and still other than the default: by a preset.
bool is_preset(const config::Options& options, const std::vector<std::string>& keys) {
    const std::vector<config::ParameterRow> rows = options.rows();
    return std::any_of(rows.begin(), rows.end(), [&](const config::ParameterRow& row) {
        return row.changed && std::find(keys.begin(), keys.end(), row.key) != keys.end();
    });
}

std::string mark(const std::string& word, bool is_default) {
    return joined(" ", element("span", {{"class", joined("mark", is_default ? "" : " given")}}, word));
}

/// Between values that each have a mark behind them: a comma would seem to belong to the mark.
constexpr const char* after_mark = " · ";

bool starts_differ(const std::vector<ReleaseSource>& sources) {
    return std::any_of(sources.begin(), sources.end(),
                       [](const ReleaseSource& source) { return source.own_start != nullptr; });
}

std::string from_low_to_high(double low, double high, int decimals) {
    return low == high
               ? fixed(low, decimals)
               : page_text("{low_decimals} to {high_decimals}", {{"low_decimals", fixed(low, decimals)},
                                                                 {"high_decimals", fixed(high, decimals)}});
}

/// Smallest and largest value over the starts of all sources.
template <class Value>
std::string range_over(const Scenario& scenario, const std::vector<ReleaseSource>& sources,
                       const Value& value_of, int decimals) {
    const StartLaw common = start_law(scenario.release);
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const ReleaseSource& source : sources) {
        const double value = value_of(source.own_start ? *source.own_start : common);
        low = std::min(low, value);
        high = std::max(high, value);
    }
    if (sources.empty()) {
        low = high = value_of(common);
    }
    return from_low_to_high(low, high, decimals);
}

const std::vector<std::string>& size_keys() {
    static const std::vector<std::string> keys{
        "release.diameter_kind",   "release.diameter_m",      "release.diameter_deviation_m",
        "release.diameter_low_m",  "release.diameter_high_m", "release.diameter_classes_m",
        "release.diameter_shares", "release.shape",           "release.shape_shares"};
    return keys;
}

/// Keys of the texts for the shapes of `release.shape`.
constexpr std::array<std::pair<std::string_view, std::string_view>, 20> texts_of_shapes{{
    {"sphere", "sphere"},
    {"cube", "cube"},
    {"octahedron", "octahedron"},
    {"ellipsoid", "ellipsoid"},
    {"equant", "equant"},
    {"plate", "plate"},
    {"column", "column"},
    {"box", "box"},
    {"rounded", "box with cut edges"},
    {"hull", "block of a file"},
    {"compact", "compact"},
    {"compact-platy", "compact-platy"},
    {"compact-bladed", "compact-bladed"},
    {"compact-elongate", "compact-elongate"},
    {"platy", "platy"},
    {"bladed", "bladed"},
    {"elongate", "elongate"},
    {"very-platy", "very platy"},
    {"very-bladed", "very bladed"},
    {"very-elongate", "very elongate"},
}};

/// "plate 60 %, cube 40 %": several shapes with their shares of the rocks.
std::string names_and_shares(const ShapeSettings& settings) {
    const std::vector<std::string> names = config::words_of_list(settings.shape);
    const double sum = std::accumulate(settings.shares.begin(), settings.shares.end(), 0.0);
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < names.size(); ++i) {
        const auto* known = std::find_if(texts_of_shapes.begin(), texts_of_shapes.end(),
                                         [&](const auto& shape) { return shape.first == names[i]; });
        texts.push_back(known == texts_of_shapes.end() ? escaped(names[i]) : page_text(known->second));
        if (names.size() > 1) {
            const double share =
                settings.shares.empty() ? 1.0 / static_cast<double>(names.size()) : settings.shares[i] / sum;
            texts.back() += joined(" ", percent(share));
        }
    }
    return join_with_commas(texts);
}

/// Names of the shapes; nothing where sources have shapes of their own.
std::string shape_of_rocks(const Scenario& scenario, const std::vector<ReleaseSource>& sources) {
    const bool own_shapes =
        rocks_have_shapes(scenario.rockfall) &&
        std::any_of(sources.begin(), sources.end(), [&](const ReleaseSource& source) {
            return source.own_start && source.own_start->shape != scenario.release.shape_law;
        });
    if (own_shapes) {
        return "";
    }
    return scenario.release.shape_law ? names_and_shares(scenario.release.shapes) : page_text("spheres");
}

std::string size_of_rocks(const Scenario& scenario, const std::vector<ReleaseSource>& sources) {
    const std::string shape = shape_of_rocks(scenario, sources);
    if (!starts_differ(sources)) {
        return marked(scenario, join_with_commas({rock_size(scenario), shape}), size_keys());
    }
    const rockfall::DiameterRange range = rockfall::diameter_range(start_law(scenario.release), sources);
    return joined(
        join_with_commas({joined(from_low_to_high(range.smallest_m, range.largest_m, 2), " m"), shape}),
        mark(page_text("by source"), false));
}

/// A value over all starts: marked as the setting where all sources share its value, otherwise as their own.
template <class Value>
std::string marked_over(const Scenario& scenario, const std::vector<ReleaseSource>& sources,
                        const Value& value_of, int decimals, const char* with_unit, const std::string& key) {
    const double common = value_of(start_law(scenario.release));
    const bool is_common = std::all_of(sources.begin(), sources.end(), [&](const ReleaseSource& source) {
        return !source.own_start || value_of(*source.own_start) == common;
    });
    const std::string text =
        page_text(with_unit, {{"value", range_over(scenario, sources, value_of, decimals)}});
    return is_common ? marked(scenario, text, {key}) : joined(text, mark(page_text("by source"), false));
}

std::string start_with_own(const Scenario& scenario, const std::vector<ReleaseSource>& sources) {
    constexpr double deg_per_rad = 57.295779513082321;
    const bool drops = scenario.release.fall_height_m > 0.0;
    return joined(
        marked_over(
            scenario, sources, [](const StartLaw& law) { return law.height_m; }, 1, "{value} m above ground",
            drops ? "release.fall_height_m" : "release.start_height_m"),
        after_mark,
        marked_over(
            scenario, sources, [](const StartLaw& law) { return law.speed_mps; }, 1, "{value} m/s",
            drops ? "release.fall_height_m" : "release.start_speed_mps"),
        after_mark,
        marked_over(
            scenario, sources, [](const StartLaw& law) { return deg_per_rad * law.dip.in_radians(); }, 1,
            "{value}° below the horizon", "release.start_dip_deg"));
}

}  // namespace

std::string verdicts_on_page(std::string_view model) {
    const std::array<std::string, judged_quantities.size()> names{
        page_text("stops"),  page_text("spread of stops"), page_text("sideways"), page_text("speed"),
        page_text("height"), page_text("energy"),          page_text("rebounds")};
    std::vector<std::string> judged;
    std::vector<std::string> others;
    const std::vector<QuantityVerdict> verdicts = verdicts_on(model);
    for (std::size_t i = 0; i < verdicts.size(); ++i) {
        const QuantityVerdict& one = verdicts[i];
        if (one.independent() == 0) {
            others.push_back(names[i]);
            continue;
        }
        judged.push_back(
            page_text("{quantity} {met} of {criteria}", {{"quantity", names[i]},
                                                         {"met", std::to_string(one.independent_met)},
                                                         {"criteria", std::to_string(one.independent())}}));
    }
    if (!others.empty()) {
        judged.push_back(page_text("not judged: {quantities}", {{"quantities", join_with_commas(others)}}));
    }
    return join_with_semicolons(judged);
}

std::string marked(const Scenario& scenario, const std::string& value, const std::vector<std::string>& keys) {
    if (scenario.options == nullptr) {
        return value;
    }
    const config::Options& options = *scenario.options;
    return joined(value, has_guess(options, keys)   ? mark(page_text("guess"), false)
                         : was_set(options, keys)   ? mark(page_text("set"), false)
                         : is_preset(options, keys) ? mark(page_text("preset"), false)
                                                    : mark(page_text("default"), true));
}

std::string start_of_rocks(const Scenario& scenario) {
    const StartLaw law = start_law(scenario.release);
    if (scenario.release.fall_height_m > 0.0) {
        return marked(
            scenario,
            page_text("dropped at rest from {law_height_m} m", {{"law_height_m", exact(law.height_m)}}),
            {"release.fall_height_m"});
    }
    const std::string height = law.height_m <= 0.0 ? std::string{page_text("rolling from the ground")}
                                                   : page_text("{law_height_m} m above ground",
                                                               {{"law_height_m", exact(law.height_m)}});
    return joined(marked(scenario, height, {"release.start_height_m"}), after_mark,
                  marked(scenario, joined(exact(law.speed_mps), " m/s"), {"release.start_speed_mps"}),
                  after_mark,
                  marked(scenario,
                         page_text("{start_dip_deg}° below the horizon",
                                   {{"start_dip_deg", exact(scenario.release.start_dip_deg)}}),
                         {"release.start_dip_deg"}));
}

std::string spread_of_directions(const Scenario& scenario) {
    if (!scenario.terrain.profile.empty()) {
        return page_text("none: two dimensions");
    }
    const std::string start =
        marked(scenario,
               page_text("±{start_scatter_deg}° around the fall line at the start",
                         {{"start_scatter_deg", exact(scenario.release.start_scatter_deg)}}),
               {"release.start_scatter_deg"});
    const rockfall::SidewaysTurn turn = rockfall::sideways_turn(scenario.rockfall);
    return joined(start, after_mark, marked(scenario, in_page_language(turn.words), turn.settings));
}

std::string deciding_facts(const Scenario& scenario, const std::vector<ReleaseSource>& sources,
                           const std::string& rocks, const std::string& sizes) {
    const bool by_source = starts_differ(sources);
    const std::string density = marked_over(
        scenario, sources, [](const StartLaw& law) { return law.density_kgpm3; }, 0, "{value} kg/m³",
        "release.density_kgpm3");
    std::string html =
        fact(page_text("Rocks"), marked(scenario, rocks, {"release.rocks", "release.rocks_per_source"}));
    html += fact(page_text("Rock diameter"), sizes.empty() ? size_of_rocks(scenario, sources) : sizes);
    html += fact(page_text("Rock density"), density);
    html +=
        fact(page_text("Start"), by_source ? start_with_own(scenario, sources) : start_of_rocks(scenario));
    html += fact(page_text("Spread of directions"), spread_of_directions(scenario));
    html += fact(page_text("Motion"), marked(scenario, motion_in_words(scenario), {"rockfall.motion"}));
    html += fact(page_text("Field cases, criteria met by this model with default settings"),
                 verdicts_on_page(rockfall::description_of(scenario.rockfall.fall.motion.model).name));
    html += fact(page_text("Preset of the rockfall laws"),
                 scenario.preset == "default" ? page_text("default") : escaped(scenario.preset));
    return joined(html, fact(page_text("Random seed"),
                             marked(scenario, std::to_string(scenario.run.seed), {"run.seed"})));
}

}  // namespace coupling::report
