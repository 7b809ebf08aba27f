#include "coupling/results/report/listings.hpp"

#include <algorithm>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/results/report/html_table.hpp"
#include "coupling/results/report/markup.hpp"

namespace coupling::report {
namespace {

using config::joined;

std::string section_of(const std::string& key) {
    return key.substr(0, key.find('.'));
}

}  // namespace

std::string fact(std::string_view name, const std::string& value) {
    return std::string{"<div><dt>"}.append(name).append("</dt><dd>").append(value).append("</dd></div>");
}

std::string rock_size(const Scenario& scenario) {
    switch (scenario.diameter_kind) {
        case DiameterKind::fixed:
            return joined(config::to_text(scenario.diameter_m), " m");
        case DiameterKind::classes: {
            const auto [low, high] =
                std::minmax_element(scenario.diameter_classes_m.begin(), scenario.diameter_classes_m.end());
            return low == scenario.diameter_classes_m.end()
                       ? "in classes"
                       : joined(config::to_text(*low), " to ", config::to_text(*high), " m, in classes");
        }
        case DiameterKind::uniform:
            return joined(config::to_text(scenario.diameter_low_m), " to ",
                          config::to_text(scenario.diameter_high_m), " m");
        case DiameterKind::lognormal:
            break;
    }
    return joined("log-normal, mean ", config::to_text(scenario.diameter_m), " m");
}

std::string motion_in_words(const Scenario& scenario) {
    switch (scenario.rockfall.fall.motion.model) {
        case rockfall::MotionModel::pir3d:
            return "PiR3D: rocks slide and do not spin, energies are those of translation alone";
        case rockfall::MotionModel::classical:
            return "Classical, constant restitution: rocks are points that do not spin, energies are those "
                   "of "
                   "translation alone";
        case rockfall::MotionModel::picus:
            break;
    }
    return "PICUS Rock’n’Roll: rocks jump, roll and spin";
}

std::string list_of_warnings(const config::Warnings& warnings) {
    if (warnings.sentences().empty()) {
        return "<p>None.</p>\n";
    }
    std::string html = "<ul class=\"notes\">";
    for (const std::string& sentence : warnings.sentences()) {
        html += joined("<li>", escaped(sentence), "</li>");
    }
    return joined(html, "</ul>\n");
}

std::string table_of_settings(const Scenario& scenario,
                              const std::function<bool(const std::string&)>& is_shown) {
    if (scenario.options == nullptr) {
        return "<p>Not recorded.</p>\n";
    }
    HtmlTable table{"Settings marked with ● differ from the default.",
                    {"setting", "value", "unit", "default", "meaning"}};
    table.text_columns({2, 4});
    std::string section;
    for (const config::ParameterRow& row : scenario.options->rows()) {
        if (!is_shown(row.key)) {
            continue;
        }
        if (section_of(row.key) != section) {
            section = section_of(row.key);
            table.group(joined("[", escaped(section), "]"));
        }
        table.row(
            {joined("<code>", escaped(row.key.substr(std::min(row.key.size(), section.size() + 1))),
                    "</code>"),
             row.value_text.empty() ? "–" : escaped(row.value_text), row.unit == "-" ? "" : escaped(row.unit),
             row.default_text.empty() ? "–" : escaped(row.default_text), escaped(row.meaning)},
            row.changed ? "changed" : "");
    }
    return joined("<section class=\"card\">", table.html(), "</section>\n");
}

std::string table_of_inputs(const std::vector<InputFile>& inputs) {
    HtmlTable table{"", {"role", "file", "bytes", "hash"}};
    table.text_columns({1});
    for (const InputFile& file : inputs) {
        table.row({escaped(file.role), escaped(file.name), grouped(file.bytes),
                   joined("<code>", escaped(file.hash), "</code>")});
    }
    return table.html();
}

std::string table_of_files(std::string_view caption, const std::vector<WrittenFile>& files) {
    HtmlTable table{caption, {"file", "holds"}};
    table.text_columns({1});
    for (const WrittenFile& file : files) {
        table.row({joined("<code>", escaped(file.path), "</code>"), escaped(file.sentence)});
    }
    return table.html();
}

std::string citation(const std::string& version, const Scenario& scenario) {
    return joined(
        "<h2>How to cite</h2>\n<p>Bannwald ", escaped(version),
        ": rockfall through forests on real terrain, GPL-3.0-or-later. Scenario ",
        escaped(scenario.file.filename().string()), ", seed ", std::to_string(scenario.seed),
        ". The rockfall model follows Rammer, W., Brauner, M., Dorren, L. K. A., Berger, F., Lexer, M. J. "
        "(2010): "
        "Evaluation of a 3-D rockfall module within a forest patch model. Natural Hazards and Earth "
        "System Sciences "
        "10, 699–711.</p>\n");
}

}  // namespace coupling::report
