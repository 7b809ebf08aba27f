#include "validation/engine/kinds/forest_case.hpp"

#include <algorithm>
#include <sstream>

#include "config/text/joined.hpp"
#include "validation/engine/forest_cases/shared/comparison.hpp"
#include "validation/engine/forest_cases/unread_files.hpp"
#include "validation/engine/years/years_case.hpp"

namespace coupling::validation {
namespace {

using config::joined;

/// What the user asks for that means something here: the settings of the kind. Those of rocks are left out
/// with a note, so that they may go with all cases at once.
std::vector<std::string> overrides_of_forest(ValidationCase& out) {
    Recipe rocks;
    config::Options known;
    declare(known, rocks);
    const std::vector<config::ParameterRow> rows = known.rows();
    std::vector<std::string> own;
    for (const std::string& text : out.changes.overrides) {
        const std::string key = known.present_name(text.substr(0, text.find('=')));
        const bool of_rocks = !key.starts_with("case.") &&
                              std::any_of(rows.begin(), rows.end(),
                                          [&](const config::ParameterRow& row) { return row.key == key; });
        if (of_rocks) {
            out.notes.push_back(joined(key, " changes nothing here: no rock falls"));
        } else {
            own.push_back(text);
        }
    }
    return own;
}

/// Reads case.ini: its head and the settings of its kind.
void read_head(ValidationCase& out, config::Options& options, const std::vector<std::string>& overrides) {
    std::istringstream in{out.files.texts.at("case.ini")};
    options.read(in, out.files.shown("case.ini"), overrides);
    if (out.head.kind != out.kind) {
        config::fail(config::ExitCode::settings, options.place_of("case.kind"), "another kind of case",
                     "the kind of its case.ini");
    }
    if (out.head.title.empty()) {
        config::fail(config::ExitCode::settings, options.place_of("case.title"), "no case.title",
                     "one line on what the case is");
    }
}

/// Settings of a scenario over years but for those of case.ini; the seed is that of the scenario.
void read_forest_years(ValidationCase& out, config::Options& options) {
    YearsSettings settings;
    declare(options, settings);
    constexpr std::string_view seed = "series.seed=";
    std::vector<std::string> of_scenario;
    std::erase_if(out.changes.overrides, [&](const std::string& change) {
        if (change.starts_with(seed)) {
            of_scenario.push_back(joined("run.seed=", change.substr(seed.size())));
        }
        return change.starts_with(seed);
    });
    std::vector<std::string> of_case;
    for (std::string& change : overrides_of_forest(out)) {
        const bool is_own = change.starts_with("case.") || change.starts_with("years.");
        (is_own ? of_case : of_scenario).push_back(std::move(change));
    }
    read_head(out, options, of_case);
    out.comparison = std::make_shared<const Comparison>(read_years(out.files, settings, of_scenario));
}

void read_forest_tables(ValidationCase& out, config::Options& options) {
    forest_cases::Settings settings;
    forest_cases::declare(options, settings, out.kind);
    read_head(out, options, overrides_of_forest(out));
    out.comparison = std::make_shared<const Comparison>(forest_cases::read(out.kind, out.files, settings));
    config::Warnings of_files;
    forest_cases::warn_of_unread_files(out.kind, out.files, of_files);
    out.warnings = of_files.all();
}

}  // namespace

void read_forest(ValidationCase& out) {
    if (out.replaces_profile()) {
        config::fail(config::ExitCode::settings, {}, joined("--profile for ", out.files.name),
                     "a case with rocks: none falls here");
    }
    if (out.changes.most_rocks) {
        out.notes.emplace_back("--rocks changes nothing here: no rock falls");
    }
    config::Options options;
    declare(options, out.head);
    out.kind == CaseKind::forest_years ? read_forest_years(out, options) : read_forest_tables(out, options);
    out.warnings.insert(out.warnings.end(), out.comparison->warnings.begin(), out.comparison->warnings.end());
    out.notes.insert(out.notes.end(), out.comparison->notes.begin(), out.comparison->notes.end());
}

}  // namespace coupling::validation
