#include "validation/engine/years/opened_sites.hpp"

#include <set>
#include <utility>

#include "config/text/joined.hpp"
#include "validation/engine/case/unpacked_case.hpp"

namespace coupling::validation::years {

using config::joined;

namespace {

/// Messages about a setting repeat it: one of no sensible length has lost a quote, or is no setting.
const std::string& setting_in(const config::Table& table, std::size_t row, const std::string& column) {
    constexpr std::size_t longest = 1000;
    const std::string& text = table.text(row, column);
    if (text.size() > longest) {
        config::fail(config::ExitCode::data, table.place(row, column),
                     joined(column, " = ", config::in_quotes(text)),
                     joined("a setting of at most ", std::to_string(longest), " characters"));
    }
    return text;
}

}  // namespace

std::vector<std::string> group_columns() {
    return {"site", "group", "species", "published", "source"};
}

std::vector<OpenedSite> open_sites(const CaseFiles& files, const std::string& scenario_file,
                                   const std::vector<std::string>& overrides, config::Warnings& warnings) {
    const UnpackedCase folder{files};
    const config::Table table = files.table(sites_file);
    config::Problems problems;
    table.require({"site", "words"}, problems);
    problems.throw_if_any();
    if (table.rows() == 0) {
        config::fail(config::ExitCode::data, {table.file()}, "no site", "one site or more");
    }
    if (files.has(groups_file)) {
        files.table(groups_file).require(group_columns(), problems);
        problems.throw_if_any();
    }
    std::vector<OpenedSite> sites;
    std::set<std::string> names;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string& name = table.text(row, "site");
        if (name.empty() || !names.insert(name).second) {
            config::fail(config::ExitCode::data, table.place(row, "site"),
                         name.empty() ? std::string{"a site without a name"}
                                      : joined("site ", config::in_quotes(name), " a second time"),
                         "each site once, with a name of its own");
        }
        std::vector<std::string> all;
        if (files.has(species_file)) {
            all.push_back(joined("forest.species=", species_file));
        }
        for (const std::string& column : table.columns()) {
            if (column.find('.') != std::string::npos && !table.text(row, column).empty()) {
                all.push_back(joined(column, "=", setting_in(table, row, column)));
            }
        }
        all.insert(all.end(), overrides.begin(), overrides.end());
        std::unique_ptr<Scenario> scenario = read_scenario(folder.path() / scenario_file, all);
        if (scenario->run.years == 0 || has_rocks(*scenario)) {
            config::fail(config::ExitCode::settings, {files.shown(scenario_file)},
                         scenario->run.years == 0 ? "run.years 0" : "rocks",
                         "a forest over years without rocks: run.years above 0, run.rockfall_every = 0");
        }
        Site site = open_site(*scenario, warnings);
        decades::Management management = decades::read_management(*scenario, *site.forest, warnings);
        sites.push_back(
            {table.text(row, "site"), std::move(scenario), std::move(site), std::move(management)});
    }
    return sites;
}

}  // namespace coupling::validation::years
