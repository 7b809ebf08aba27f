#include "validation/engine/forest_cases/unread_files.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "validation/engine/forest_cases/shared/comparison.hpp"

namespace coupling::validation::forest_cases {
namespace {

using config::joined;

/// Tables of a kind, those of every kind left out.
std::vector<std::string> tables_of(CaseKind kind) {
    switch (kind) {
        case CaseKind::forest_production:
            return {"runs.csv",         "demo_site.csv",    "demo_species.csv", "demo_parameters.csv",
                    "demo_climate.csv", "demo_thinning.csv"};
        case CaseKind::forest_light:
            return {"trees.csv", "leaves.csv", "radiation.csv", "slopes.csv", "ground.csv", "sensors.csv"};
        case CaseKind::slope:
        case CaseKind::profile:
        case CaseKind::factors:
        case CaseKind::field:
        case CaseKind::collapse:
        case CaseKind::forest_years:
            break;
    }
    return {};
}

/// Files that runs.csv names in any of its fields.
std::set<std::string> named_in_runs(const CaseFiles& files) {
    std::set<std::string> named;
    const config::Table runs = files.table("runs.csv");
    for (std::size_t row = 0; row < runs.rows(); ++row) {
        for (const std::string& column : runs.columns()) {
            named.insert(runs.text(row, column));
        }
    }
    return named;
}

}  // namespace

void warn_of_unread_files(CaseKind kind, const CaseFiles& files, config::Warnings& warnings) {
    const std::vector<std::string> known = tables_of(kind);
    std::set<std::string> read{known.begin(), known.end()};
    if (kind == CaseKind::forest_production) {
        read.merge(named_in_runs(files));
    }
    warn_of_unread_files(files, read, warnings);
}

void warn_of_unread_files(const CaseFiles& files, std::set<std::string> read, config::Warnings& warnings) {
    read.insert("criteria.csv");
    std::vector<std::string> absent;
    std::copy_if(read.begin(), read.end(), std::back_inserter(absent),
                 [&](const std::string& name) { return !files.has(name); });
    for (const auto& [name, text] : files.texts) {
        if (!name.ends_with(".csv") || read.contains(name)) {
            continue;
        }
        const std::string meant = config::nearest_word(name, absent);
        warnings.add(joined(files.shown(name), " is not read; ",
                            meant.empty() ? std::string{"rename it if it is one of the tables in "
                                                        "validation/README.md, keep it if it is your own"}
                                          : joined("if it is ", config::in_quotes(meant),
                                                   ", give it that name; keep it if it is your own")));
    }
}

}  // namespace coupling::validation::forest_cases
