#include "validation/engine/years/opened_sites.hpp"

#include <filesystem>
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

/// A problem with the scenario at a site, where its row says so: the column of a setting, else the row.
config::Problem at_site(config::Problem problem, const config::Table& table, std::size_t row) {
    for (const std::string& column : table.columns()) {
        if (!table.text(row, column).empty() &&
            problem.place.file == joined("--set ", column, "=", table.text(row, column))) {
            problem.place = table.place(row, column);
            return problem;
        }
    }
    const config::Place place = table.place(row, "site");
    problem.advice += joined(problem.advice.empty() ? "" : "; ", "seen at site ",
                             config::in_quotes(table.text(row, "site")), ", ", place.file, ", line ",
                             std::to_string(place.line));
    return problem;
}

/// What differs at a site, as overrides of the scenario.
std::vector<std::string> settings_of(const CaseFiles& files, const config::Table& table, std::size_t row) {
    std::vector<std::string> all;
    if (files.has(species_file)) {
        all.push_back(joined("forest.species=", species_file));
    }
    for (const std::string& column : table.columns()) {
        if (column.find('.') != std::string::npos && !table.text(row, column).empty()) {
            all.push_back(joined(column, "=", setting_in(table, row, column)));
        }
    }
    return all;
}

/// The scenario with the settings of a site. Throws InputError.
OpenedSite open_scenario(const std::string& site, const std::filesystem::path& file,
                         const std::string& shown_file, const std::vector<std::string>& overrides,
                         config::Warnings& warnings) {
    std::unique_ptr<Scenario> scenario = read_scenario(file, overrides);
    if (scenario->run.years == 0 || has_rocks(*scenario)) {
        config::fail(config::ExitCode::settings, {shown_file},
                     scenario->run.years == 0 ? "run.years 0" : "rocks",
                     "a forest over years without rocks: run.years above 0, run.rockfall_every = 0");
    }
    Site opened = open_site(*scenario, warnings);
    decades::Management management = decades::read_management(*scenario, *opened.forest, warnings);
    return {site, std::move(scenario), std::move(opened), std::move(management)};
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
        std::vector<std::string> all = settings_of(files, table, row);
        all.insert(all.end(), overrides.begin(), overrides.end());
        try {
            sites.push_back(open_scenario(name, folder.path() / scenario_file, files.shown(scenario_file),
                                          all, warnings));
        } catch (const config::InputError& error) {
            for (const config::Problem& problem : error.problems()) {
                problems.add(at_site(problem, table, row));
            }
            problems.throw_if_any();
        }
    }
    return sites;
}

}  // namespace coupling::validation::years
