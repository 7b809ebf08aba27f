#include "coupling/results/report/listings.hpp"

#include <algorithm>
#include <set>

#include "config/text/joined.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/results/report/first_warnings.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/messages.hpp"
#include "coupling/results/text/page_text.hpp"
#include "coupling/results/text/phrases.hpp"
#include "coupling/results/text/scenario_names.hpp"
#include "rockfall/motion/models.hpp"

namespace coupling::report {
namespace {

using config::joined;

std::string section_of(const std::string& key) {
    return key.substr(0, key.find('.'));
}

std::string settings_table(const Scenario& scenario, const std::string& caption,
                           const std::function<bool(const config::ParameterRow&)>& is_shown) {
    if (scenario.options == nullptr) {
        return filled_template("settings_table.html", {{"recorded", false}});
    }
    HtmlTable table{caption,
                    {page_text("setting"), page_text("value"), page_text("unit"), page_text("default"),
                     page_text("meaning")}};
    table.text_columns({2, 4});
    std::string section;
    for (const config::ParameterRow& row : scenario.shown_settings()) {
        if (!is_shown(row)) {
            continue;
        }
        if (section_of(row.key) != section) {
            section = section_of(row.key);
            table.group(joined("[", escaped(section), "]"));
        }
        table.row({element("code", {}, escaped(row.key.substr(std::min(row.key.size(), section.size() + 1)))),
                   row.value_text.empty() ? "–" : escaped(with_scenario_names(row.value_text)),
                   row.unit == "-" ? "" : escaped(message_text(row.unit)),
                   row.default_text.empty() ? "–" : escaped(row.default_text), message_html(row.meaning)},
                  row.changed ? "changed" : "");
    }
    return filled_template("settings_table.html", {{"recorded", true}, {"table", table.html()}});
}

/// Lists up to this length stand open [choice]: about a third of a screen.
constexpr std::size_t most_notes_open = 12;

std::vector<PageFields> messages_of(const std::vector<std::string>& sentences) {
    std::vector<PageFields> items;
    for (const std::string& sentence : sentences) {
        items.push_back({{"sentence", message_html(sentence)}});
    }
    return items;
}

}  // namespace

std::string fact(std::string_view name, const std::string& value) {
    return element("div", {}, joined(element("dt", {}, name), element("dd", {}, value)));
}

std::string rock_size(const Scenario& scenario) {
    switch (scenario.release.diameter_kind) {
        case DiameterKind::fixed:
            return joined(exact(scenario.release.diameter_m), " m");
        case DiameterKind::classes: {
            const auto [low, high] = std::minmax_element(scenario.release.diameter_classes_m.begin(),
                                                         scenario.release.diameter_classes_m.end());
            return low == scenario.release.diameter_classes_m.end()
                       ? page_text("in classes")
                       : page_text("{low} to {high} m, in classes",
                                   {{"low", exact(*low)}, {"high", exact(*high)}});
        }
        case DiameterKind::uniform:
            return page_text("{diameter_low_m} to {diameter_high_m} m",
                             {{"diameter_low_m", exact(scenario.release.diameter_low_m)},
                              {"diameter_high_m", exact(scenario.release.diameter_high_m)}});
        case DiameterKind::lognormal:
            break;
    }
    return page_text("log-normal, mean {diameter_m} m", {{"diameter_m", exact(scenario.release.diameter_m)}});
}

std::string motion_in_words(const Scenario& scenario) {
    const rockfall::ModelDescription& model = rockfall::description_of(scenario.rockfall.fall.motion.model);
    return with_label(in_page_language(model.title), in_page_language(model.rocks));
}

std::string list_of_warnings(const config::Warnings& warnings) {
    const std::vector<std::string>& notes = warnings.notes();
    const std::set<std::string> above = open_first(warnings);
    std::vector<PageFields> items;
    for (const std::string& sentence : warnings.warnings()) {
        items.push_back({{"sentence", message_html(sentence)}, {"is_above", above.contains(sentence)}});
    }
    const bool are_all_above = are_all_first(warnings);
    return filled_template("warnings_and_notes.html", {{"has_warnings", !warnings.warnings().empty()},
                                                       {"stand_above", are_all_above},
                                                       {"some_stand_above", !are_all_above && !above.empty()},
                                                       {"warnings", items},
                                                       {"has_notes", !notes.empty()},
                                                       {"are_folded", notes.size() > most_notes_open},
                                                       {"number", std::to_string(notes.size())},
                                                       {"notes", messages_of(notes)}});
}

std::string table_of_settings(const Scenario& scenario,
                              const std::function<bool(const std::string&)>& is_shown) {
    return settings_table(scenario, page_text("Settings marked with ● differ from the default."),
                          [&](const config::ParameterRow& row) { return is_shown(row.key); });
}

namespace {

/// Settings that differ from their defaults, for a paragraph: the table of all is too long for paper.
std::string changed_settings(const Scenario& scenario,
                             const std::function<bool(const std::string&)>& is_shown) {
    std::vector<std::string> settings;
    for (const config::ParameterRow& row : scenario.shown_settings()) {
        if (row.changed && is_shown(row.key)) {
            settings.push_back(joined(row.key, " = ", with_scenario_names(row.value_text)));
        }
    }
    return join_with_semicolons(settings);
}

}  // namespace

std::string settings_section(const Scenario& scenario,
                             const std::function<bool(const std::string&)>& is_shown) {
    return filled_template(
        "settings_section.html",
        {{"differing",
          settings_table(scenario, "",
                         [&](const config::ParameterRow& row) { return row.changed && is_shown(row.key); })},
         {"all", table_of_settings(scenario, is_shown)},
         {"on_paper", scenario.options == nullptr
                          ? std::nullopt
                          : std::optional{PageFields{{"settings", changed_settings(scenario, is_shown)}}}}});
}

std::string table_of_inputs(const std::vector<InputFile>& inputs) {
    HtmlTable table{"", {page_text("role"), page_text("file"), page_text("bytes"), page_text("hash")}};
    table.text_columns({1});
    for (const InputFile& file : inputs) {
        table.row({message_html(file.role), escaped(with_scenario_names(file.name)), grouped(file.bytes),
                   element("code", {}, escaped(file.hash))});
    }
    return table.html();
}

std::string table_of_files(std::string_view caption, const std::vector<WrittenFile>& files) {
    HtmlTable table{caption, {page_text("file"), page_text("holds")}};
    table.text_columns({1});
    for (const WrittenFile& file : files) {
        table.row({element("code", {}, escaped(file.path)), message_html(file.sentence)});
    }
    return table.html();
}

std::string citation(const std::string& version, const Scenario& scenario) {
    const rockfall::MotionModel model = scenario.rockfall.fall.motion.model;
    const rockfall::ModelDescription& description = rockfall::description_of(model);
    return filled_template("citation.html", {{"version", version},
                                             {"file", scenario.file.filename().string()},
                                             {"seed", std::to_string(scenario.run.seed)},
                                             {"is_other_model", model != rockfall::MotionModel{}},
                                             {"title", in_page_language(description.title)},
                                             {"source", std::string{description.source}}});
}

}  // namespace coupling::report
