#include "validation/engine/kinds/forest_case.hpp"

#include <algorithm>
#include <sstream>

#include "config/text/joined.hpp"
#include "validation/engine/forest_cases/shared/comparison.hpp"
#include "validation/engine/forest_cases/unread_files.hpp"

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
    forest_cases::Settings settings;
    declare(options, out.head);
    forest_cases::declare(options, settings, out.kind);
    std::istringstream in{out.files.texts.at("case.ini")};
    options.read(in, out.files.shown("case.ini"), overrides_of_forest(out));
    if (out.head.kind != out.kind) {
        config::fail(config::ExitCode::settings, options.place_of("case.kind"), "another kind of case",
                     "the kind of its case.ini");
    }
    if (out.head.title.empty()) {
        config::fail(config::ExitCode::settings, options.place_of("case.title"), "no case.title",
                     "one line on what the case is");
    }
    out.comparison = std::make_shared<const Comparison>(forest_cases::read(out.kind, out.files, settings));
    config::Warnings of_files;
    forest_cases::warn_of_unread_files(out.kind, out.files, of_files);
    out.warnings = of_files.all();
    out.warnings.insert(out.warnings.end(), out.comparison->warnings.begin(), out.comparison->warnings.end());
    out.notes.insert(out.notes.end(), out.comparison->notes.begin(), out.comparison->notes.end());
}

}  // namespace coupling::validation
