#include "validation/engine/years/years_case.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <utility>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/assessments/decades/members/simulate.hpp"
#include "coupling/assessments/decades/tables/decade_tables.hpp"
#include "coupling/assessments/decades/tables/profile_tables.hpp"
#include "coupling/assessments/decades/tables/work_tables.hpp"
#include "coupling/assessments/decades/whole_run.hpp"
#include "coupling/inputs/scenario/scenario.hpp"
#include "coupling/run/first_error.hpp"
#include "coupling/run/interrupt.hpp"
#include "validation/engine/case/over_seeds.hpp"
#include "validation/engine/case/unpacked_case.hpp"
#include "validation/engine/forest_cases/shared/comparison.hpp"
#include "validation/engine/forest_cases/shared/unknown_columns.hpp"
#include "validation/engine/forest_cases/unread_files.hpp"
#include "validation/engine/years/changed_laws.hpp"
#include "validation/engine/years/checks.hpp"
#include "validation/engine/years/drawn.hpp"
#include "validation/engine/years/opened_sites.hpp"
#include "validation/engine/years/standard_queries.hpp"

namespace coupling::validation {
namespace {

using config::joined;
using years::Fields;
using years::group_columns;
using years::groups_file;
using years::OpenedSite;
using years::Query;
using years::QueryUse;
using years::ResultTables;
using years::sites_file;
using years::species_file;

/// A figure of one row of the table that its query names.
struct AskedFigure {
    std::string name;
    std::size_t query = 0;
    Fields fields;
};

struct YearsCase {
    YearsSettings settings;
    std::vector<OpenedSite> sites;
    std::vector<Query> queries;
    std::unique_ptr<ResultTables> tables;
    std::vector<AskedFigure> figures;
    bool has_groups = false;  ///< expected.csv
    Fields asked;             ///< first and last year of the figures, for captions
};

/// What queries know before anything is simulated: species, area of each site, the years asked for.
void make_own_tables(YearsCase& years) {
    const forest::SpeciesTable& species = years.sites.front().site.forest->species.table;
    std::vector<std::vector<std::string>> names;
    for (const forest::Species& kind : species.all()) {
        names.push_back({kind.code, forest_cases::code_in_figures(kind), kind.latin_name,
                         config::to_text(kind.mortality.thinning_intercept),
                         config::to_text(kind.mortality.thinning_slope)});
    }
    std::vector<std::vector<std::string>> places;
    for (const OpenedSite& site : years.sites) {
        const ForestSite& forest = *site.site.forest;
        places.push_back({site.name, config::to_text(forest.grid.area_ha()),
                          config::to_text(forest.place.units().front().elevation_m),
                          forest.climates.front().source.changes() ? "1" : "0",
                          site.scenario->forest.list_all_removed ? "1" : "0"});
    }
    years.tables->make("species_names",
                       {"species", "code", "latin_name", "thinning_intercept", "thinning_slope"}, names);
    years.tables->make("places", {"site", "area_ha", "elevation_m", "changed", "all_deaths"}, places);
    years.tables->make("figures", {"figure", "value"}, {}, true);
    years.tables->database().execute("CREATE INDEX figures_by_name ON figures (figure);");
    if (!years.has_groups) {
        years.tables->make("expected", group_columns(), {});
    }
    years.tables->make("asked", {"from_year", "last_year"},
                       {{years.asked.at("from_year"), years.asked.at("last_year")}});
}

/// Refuses what would be missing or counted twice at the end of the run, and parameters that are no fields.
void check_figure(const YearsCase& years, const Query& query, const std::string& name, const Fields& fields) {
    const auto field = fields.find("site");
    const std::string site = field == fields.end() ? "" : field->second;
    if (!site.empty() && std::none_of(years.sites.begin(), years.sites.end(),
                                      [&](const OpenedSite& one) { return one.name == site; })) {
        config::fail(config::ExitCode::data, query.place,
                     joined("site ", config::in_quotes(site), " in ", query.rows),
                     joined("a site of ", sites_file));
    }
    if (std::any_of(years.figures.begin(), years.figures.end(),
                    [&](const AskedFigure& one) { return one.name == name; })) {
        config::fail(config::ExitCode::data, query.place, joined("figure ", name, " a second time"),
                     joined("each row of ", query.rows, " with a name of its own"));
    }
    static_cast<void>(years::value_of(years.tables->database(), query, fields));
}

/// Definitions are carried out, checks of tables asked, figures listed by the rows of their tables, the rest
/// tried.
void prepare_queries(YearsCase& years, const CaseFiles& files, Comparison& comparison,
                     config::Warnings& warnings) {
    geopackage::Database& database = years.tables->database();
    for (std::size_t q = 0; q < years.queries.size(); ++q) {
        const Query& query = years.queries[q];
        const int columns_of_query = years::prepared(database, query).columns();
        if (query.use == QueryUse::definition) {
            if (columns_of_query > 0) {
                config::fail(config::ExitCode::data, query.place, "a statement whose rows nothing shows",
                             "CREATE VIEW, or -- figure, -- table or the like in the line above");
            }
            static_cast<void>(years::rows_of(database, query));
            continue;
        }
        if (query.use == QueryUse::warning || query.use == QueryUse::error) {
            years::run_check(database, query, files, warnings);
            continue;
        }
        if (query.use != QueryUse::figure) {
            static_cast<void>(years::filled(query.title, years.asked, query.place));
            static_cast<void>(years::rows_of(database, query));
            continue;
        }
        Query every = query;
        every.sql = joined("SELECT * FROM ", query.rows, ";");
        const std::vector<std::vector<std::string>> rows = years::rows_of(database, every);
        const geopackage::Statement columns = years::prepared(database, every);
        for (const std::vector<std::string>& row : rows) {
            Fields fields = years.asked;
            for (std::size_t i = 0; i < row.size(); ++i) {
                fields[columns.name(static_cast<int>(i))] = row[i];
            }
            const std::string name = years::filled(query.title, fields, query.place);
            check_figure(years, query, name, fields);
            comparison.figures.push_back({name, years::filled(query.label, fields, query.place), query.unit});
            const std::string observed = years::filled(query.observed, fields, query.place);
            if (const auto value = config::parse_number(observed)) {
                comparison.references[name] = {*value, "observed"};
            }
            years.figures.push_back({name, q, std::move(fields)});
        }
    }
}

/// States of species between the years that figures see are dropped: they fill the memory.
void thin_states(decades::MemberYears& member, std::uint64_t every) {
    std::erase_if(member.stands, [every](const decades::StandRow& row) {
        return static_cast<std::uint64_t>(row.year) % every != 0;
    });
}

/// A member of the run of a site.
struct Piece {
    std::size_t site = 0;
    decades::Member member;
    decades::MemberYears years{};
};

/// The members of a site.
std::vector<Piece> pieces_of(const YearsCase& years, std::size_t s) {
    const OpenedSite& site = years.sites[s];
    std::vector<Piece> pieces;
    for (const decades::Member& member :
         decades::members_of(*site.scenario, decades::names_of(site.management, *site.site.forest))) {
        pieces.push_back({s, member});
    }
    return pieces;
}

/// Several members at a time. Throws Interrupted.
void simulate(const YearsCase& years, const Work& work, std::vector<Piece>& pieces) {
    FirstError error;
#pragma omp parallel for schedule(dynamic, 1) num_threads(work.threads)
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        error.guard([&] {
            const OpenedSite& site = years.sites[pieces[i].site];
            const decades::Decades run{*site.scenario, *site.site.forest, site.management};
            pieces[i].years = decades::simulate(run, pieces[i].member, 1, [&] {
                if (InterruptGuard::requested()) {
                    throw Interrupted{};
                }
#pragma omp critical(years_done)
                work.done(1);
            });
            thin_states(pieces[i].years, years.settings.states_every);
        });
    }
    error.rethrow();
}

/// The figures of a site, or with "" those of no single one; each sees the values of those before it.
void compute_figures(const YearsCase& years, const std::string& site, Outcome& outcome) {
    for (const AskedFigure& figure : years.figures) {
        const auto of = figure.fields.find("site");
        if ((of == figure.fields.end() ? "" : of->second) == site) {
            const double value =
                years::value_of(years.tables->database(), years.queries[figure.query], figure.fields);
            outcome.values[figure.name] = value;
            years.tables->fill("figures", {{figure.name, std::isnan(value) ? "" : config::to_text(value)}});
        }
    }
}

/// The tables of a site as `bannwald run` writes them, then its figures.
void take_site(const YearsCase& years, std::size_t s, const std::vector<decades::MemberYears>& members,
               Outcome& outcome) {
    const OpenedSite& site = years.sites[s];
    const auto names = decades::names_of(site.management, *site.site.forest);
    const TemporaryFolder folder;
    make_folder(folder.path() / "tables");
    decades::write_forest_tables(
        folder.path(), names, members,
        chosen_years(site.scenario->forest.tree_list_years, site.scenario->run.years));
    decades::write_work_tables(folder.path(), names, members, site.site.forest->grid.area_ha());
    decades::write_profile_tables(folder.path(), names, members, std::nullopt);
    years.tables->add(site.name, folder.path());
    compute_figures(years, site.name, outcome);
    std::istringstream done{years.settings.forget};
    for (std::string table; done >> table;) {
        years.tables->database().execute(joined("DELETE FROM ", geopackage::sql_name(table), ";"));
    }
}

/// Sites in batches that keep all threads busy: their members fill the memory.
Outcome compare_years(const YearsCase& years, const Work& work) {
    Outcome outcome;
    for (std::size_t first = 0; first < years.sites.size();) {
        std::vector<Piece> pieces;
        std::size_t end = first;
        while (end < years.sites.size() && pieces.size() < 4 * static_cast<std::size_t>(work.threads)) {
            std::vector<Piece> more = pieces_of(years, end++);
            std::move(more.begin(), more.end(), std::back_inserter(pieces));
        }
        simulate(years, work, pieces);
        for (; first < end; ++first) {
            std::vector<decades::MemberYears> members;
            for (Piece& piece : pieces) {
                if (piece.site == first) {
                    members.push_back(std::move(piece.years));
                }
            }
            take_site(years, first, members, outcome);
        }
    }
    compute_figures(years, "", outcome);
    years::draw(*years.tables, years.queries, years.asked, outcome);
    return outcome;
}

/// Tables of the folder that neither the scenario nor a query reads, and columns of its tables.
void warn_of_what_is_not_read(const CaseFiles& files, const YearsCase& years, config::Warnings& warnings) {
    std::set<std::string> inputs{species_file};
    for (const OpenedSite& site : years.sites) {
        for (const std::vector<InputFile>* of : {&site.site.inputs, &site.management.inputs}) {
            for (const InputFile& input : *of) {
                inputs.insert(std::filesystem::path{input.name}.filename().string());
            }
        }
    }
    std::set<std::string> read = inputs;
    read.insert({sites_file, groups_file});
    for (const auto& [file, text] : files.texts) {
        if (!years.tables->holds(file) || inputs.contains(file)) {
            continue;  // the scenario warns of its own
        }
        read.insert(file);
        const config::Table table = files.table(file);
        std::vector<std::string> known{"site", "words"};
        const std::vector<std::string> of_groups = group_columns();
        known.insert(known.end(), of_groups.begin(), of_groups.end());
        std::copy_if(table.columns().begin(), table.columns().end(), std::back_inserter(known),
                     [&](const std::string& column) {
                         return column.find('.') != std::string::npos || years.tables->is_named(column);
                     });
        forest_cases::warn_of_unknown_columns(table, known, warnings);
    }
    if (years.has_groups) {
        const config::Table groups = files.table(groups_file);
        for (std::size_t row = 0; row < groups.rows(); ++row) {
            const std::string& name = groups.text(row, "site");
            if (std::none_of(years.sites.begin(), years.sites.end(),
                             [&](const OpenedSite& site) { return site.name == name; })) {
                warnings.add(joined(groups.file(), ": site ", config::in_quotes(name), " is not in ",
                                    sites_file, "; its groups are left out"));
            }
        }
    }
    forest_cases::warn_of_unread_files(files, read, warnings);
}

/// Figures of all sites speak of the same years, and see at least one state.
void check_years(const YearsCase& years, const CaseFiles& files) {
    const std::uint64_t last = years.sites.front().scenario->run.years;
    const YearsSettings& settings = years.settings;
    if (settings.from_year > last) {
        config::fail(config::ExitCode::settings, {},
                     joined("years.from_year ", std::to_string(settings.from_year)),
                     "a year up to run.years");
    }
    if (last / settings.states_every * settings.states_every < settings.from_year) {
        config::fail(config::ExitCode::settings, {},
                     joined("years.states_every ", std::to_string(settings.states_every)),
                     joined("a multiple of it in the years ", std::to_string(settings.from_year), " to ",
                            std::to_string(last)));
    }
    for (const OpenedSite& site : years.sites) {
        if (site.scenario->run.years != last) {
            config::fail(config::ExitCode::settings, {files.shown(sites_file)},
                         joined("run.years ", std::to_string(site.scenario->run.years), " at ", site.name),
                         joined("the ", std::to_string(last), " of the first site"));
        }
    }
}

/// Tables that are dropped are those of the run; members that the standard figures put together differ by
/// chance alone.
void check_tables(const YearsCase& years, const CaseFiles& files) {
    std::istringstream forgotten{years.settings.forget};
    for (std::string table; forgotten >> table;) {
        if (!years.tables->is_of_run(table)) {
            config::fail(config::ExitCode::settings, {files.shown("case.ini")},
                         joined("years.forget with ", config::in_quotes(table)),
                         "names of tables of a run, such as mortality");
        }
    }
    for (const OpenedSite& site : years.sites) {
        if (years.settings.standard && decades::names_of(site.management, *site.site.forest).courses() > 1) {
            config::fail(config::ExitCode::settings, {files.shown(years.settings.scenario)},
                         joined("several regimes or climates at ", site.name),
                         "one, or years.standard = no: the standard figures are means over all members");
        }
    }
}

/// What reads the case again with the seeds that follow that of the scenario.
std::vector<std::function<Comparison()>> with_more_seeds(const CaseFiles& files, YearsSettings settings,
                                                         std::vector<std::string> overrides,
                                                         std::uint64_t first_seed) {
    std::vector<std::function<Comparison()>> more;
    const auto kept = std::make_shared<const CaseFiles>(files);
    const std::uint64_t seeds = std::exchange(settings.seeds, 1);
    std::erase_if(overrides, [](const std::string& one) { return one.starts_with("run.seed="); });
    for (std::uint64_t seed = first_seed + 1; seed < first_seed + seeds; ++seed) {
        overrides.push_back(joined("run.seed=", std::to_string(seed)));
        more.emplace_back([kept, settings, overrides] { return read_years(*kept, settings, overrides); });
        overrides.pop_back();
    }
    return more;
}

}  // namespace

void declare(config::Options& options, YearsSettings& settings) {
    options.text("years.scenario", settings.scenario,
                 {.meaning = "scenario of `bannwald run` in the folder of the case"});
    options.text("years.figures", settings.figures,
                 {.meaning = "SQL of figures, tables and charts of the case, beside the standard ones"});
    options.flag("years.standard", settings.standard,
                 {.meaning = "figures, tables and charts that every case over years may have"});
    options.text("years.forget", settings.forget,
                 {.meaning = "result tables, apart by blanks, that are dropped once a site has its figures: "
                             "charts and figures of several sites do not need them"});
    options.count("years.from_year", settings.from_year,
                  {.unit = "years",
                   .low = 1.0,
                   .high = 1000.0,
                   .meaning = "figures look at this year of the run and those after it"});
    options.count(
        "years.seeds", settings.seeds,
        {.unit = "-",
         .low = 1.0,
         .high = 1000.0,
         .meaning = "seeds that the case runs with, from that of the scenario on: figures are means "
                    "over them, with the standard deviation between them"});
    options.count("years.states_every", settings.states_every,
                  {.unit = "years",
                   .low = 1.0,
                   .high = 1000.0,
                   .meaning = "figures see what stands (stands.csv, dbh_classes.csv) every so many years; "
                              "what happened in a year (all other tables) of each"});
}

Comparison read_years(const CaseFiles& files, const YearsSettings& settings,
                      const std::vector<std::string>& overrides) {
    auto years = std::make_shared<YearsCase>();
    years->settings = settings;
    config::Warnings warnings;
    years->sites = years::open_sites(files, settings.scenario, overrides, warnings);
    const OpenedSite& first = years->sites.front();
    check_years(*years, files);
    years->asked = {{"from_year", std::to_string(settings.from_year)},
                    {"last_year", std::to_string(first.scenario->run.years)}};
    years->queries = years::queries_of(files, settings);
    years->tables = std::make_unique<ResultTables>(files, years->queries, first.site.forest->species.table,
                                                   files.shown(settings.figures));
    years->has_groups = files.has(groups_file);
    check_tables(*years, files);
    make_own_tables(*years);
    Comparison comparison;
    prepare_queries(*years, files, comparison, warnings);
    std::vector<const Scenario*> scenarios;
    for (const OpenedSite& site : years->sites) {
        scenarios.push_back(site.scenario.get());
        const auto names = decades::names_of(site.management, *site.site.forest);
        comparison.pieces += site.scenario->run.years * decades::members_of(*site.scenario, names).size();
    }
    comparison.extent = joined(counted(years->sites.size(), "site"), ", ",
                               counted(first.scenario->forest.replicates, "replicate"), " of ",
                               config::to_text(first.site.forest->grid.area_ha()), " ha over ",
                               std::to_string(first.scenario->run.years), " years");
    warn_of_what_is_not_read(files, *years, warnings);
    comparison.warnings = warnings.warnings();
    if (const std::string laws = years::changed_laws(scenarios); !laws.empty()) {
        comparison.notes.push_back(joined("not the defaults of a run: ", laws));
    }
    comparison.notes.insert(comparison.notes.end(), warnings.notes().begin(), warnings.notes().end());
    comparison.run = [years](const Work& work) { return compare_years(*years, work); };
    return over_seeds(std::move(comparison),
                      with_more_seeds(files, settings, overrides, first.scenario->run.seed));
}

}  // namespace coupling::validation
