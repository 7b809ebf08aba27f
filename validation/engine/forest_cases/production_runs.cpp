#include "validation/engine/forest_cases/production_runs.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"
#include "validation/engine/forest_cases/compared_columns.hpp"
#include "validation/engine/forest_cases/production_checks.hpp"
#include "validation/engine/forest_cases/shared/comparison.hpp"
#include "validation/engine/forest_cases/shared/unknown_columns.hpp"

namespace coupling::validation::forest_cases {
namespace {

using config::joined;

namespace check = plain_3pg;

/// The texts between a sign, without the blanks around it.
std::vector<std::string> between(const std::string& text, char sign) {
    std::vector<std::string> parts;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(sign, begin), text.size());
        parts.emplace_back(config::trimmed(std::string_view{text}.substr(begin, end - begin)));
        begin = end + 1;
    }
    return parts;
}

/// One row of runs.csv. Columns that are left out have the names of the shipped case.
class RunRow {
public:
    RunRow(const CaseFiles& files, const config::Table& runs, std::size_t row)
        : files_{files}, runs_{runs}, row_{row} {}

    [[nodiscard]] std::string text_or(const char* column, const char* otherwise) const {
        const std::string text = runs_.has(column) ? runs_.text(row_, column) : std::string{};
        return text.empty() ? otherwise : text;
    }
    [[nodiscard]] config::Table table(const char* column, const char* otherwise) const {
        return files_.table(text_or(column, otherwise));
    }
    [[nodiscard]] check::Inputs inputs() const {
        const check::Site site = check::read_site(this->site());
        std::vector<check::StartingSpecies> species = starting_species();
        require_parameters(species);
        std::vector<check::Thinning> list = thinnings(species);
        return check::inputs_of(site, std::move(species), check::read_parameters(parameters()),
                                check::read_climate(climate(), site), std::move(list));
    }
    [[nodiscard]] config::Table site() const { return table("site", "demo_site.csv"); }
    [[nodiscard]] config::Table start() const { return table("start", "demo_species.csv"); }
    [[nodiscard]] config::Table parameters() const { return table("parameters", "demo_parameters.csv"); }
    [[nodiscard]] config::Table climate() const { return table("climate", "demo_climate.csv"); }
    [[nodiscard]] check::Settings settings(config::Problems& problems) const {
        const std::string& models = runs_.text(row_, "models");
        if (models != "3-PGpjs" && models != "3-PGmix") {
            problems.add(config::ExitCode::data, runs_.place(row_, "models"), config::in_quotes(models),
                         "3-PGpjs or 3-PGmix");
        }
        check::Settings settings = models == "3-PGmix" ? check::mixture_settings : check::Settings{};
        const std::string height = text_or("height", "power");
        if (height != "power" && height != "exponential") {
            problems.add(config::ExitCode::data, runs_.place(row_, "height"), config::in_quotes(height),
                         "power (height model 1 of r3PG) or exponential (model 2)");
        }
        settings.height =
            height == "exponential" ? check::HeightModel::exponential : check::HeightModel::power;
        return settings;
    }

private:
    void require_parameters(const std::vector<check::StartingSpecies>& species) const {
        const config::Table given = parameters();
        config::Problems problems;
        for (const check::StartingSpecies& one : species) {
            if (!given.has(one.species)) {
                const std::string nearest = config::nearest_word(one.species, given.columns());
                problems.add(config::ExitCode::data, {given.file()},
                             joined("no parameters of ", config::in_quotes(one.species)),
                             joined("a column for each species of run ", runs_.text(row_, "run")),
                             nearest.empty() ? "add the column, spelt as in the other tables"
                                             : joined("if it is the column ", config::in_quotes(nearest),
                                                      ", spell it alike in all tables"));
            }
        }
        problems.throw_if_any();
    }

    /// Those of the run, in the order of its starting table.
    [[nodiscard]] std::vector<check::StartingSpecies> starting_species() const {
        const std::vector<std::string> wanted = between(runs_.text(row_, "species"), '+');
        const std::string file = text_or("start", "demo_species.csv");
        std::vector<check::StartingSpecies> species;
        std::vector<std::string> names;
        for (check::StartingSpecies& candidate : check::read_species(files_.table(file))) {
            names.push_back(candidate.species);
            if (std::find(wanted.begin(), wanted.end(), candidate.species) != wanted.end()) {
                species.push_back(std::move(candidate));
            }
        }
        for (const std::string& one : wanted) {
            if (std::find(names.begin(), names.end(), one) == names.end()) {
                const std::string nearest = config::nearest_word(one, names);
                config::fail(config::ExitCode::data, runs_.place(row_, "species"),
                             joined("species ", config::in_quotes(one)),
                             joined("a species of ", files_.shown(file), ", or several with + between them"),
                             nearest.empty() ? "add its row there, or correct the name"
                                             : joined("if it is ", config::in_quotes(nearest),
                                                      ", spell it alike in all tables"));
            }
        }
        if (species.size() != wanted.size()) {
            config::fail(config::ExitCode::data, runs_.place(row_, "species"),
                         joined("a species twice: ", config::in_quotes(runs_.text(row_, "species"))),
                         joined("each species once, here and in ", files_.shown(file)));
        }
        return species;
    }

    [[nodiscard]] bool is_thinned() const {
        const std::string thinned = text_or("thinned", "no");
        if (thinned != "yes" && thinned != "no") {
            config::fail(config::ExitCode::data, runs_.place(row_, "thinned"),
                         joined("thinned ", config::in_quotes(thinned)), "yes or no");
        }
        return thinned == "yes";
    }

    [[nodiscard]] std::vector<check::Thinning> thinnings(
        const std::vector<check::StartingSpecies>& species) const {
        if (!is_thinned()) {
            return {};
        }
        const config::Table given = table("thinning", "demo_thinning.csv");
        std::vector<check::Thinning> all = check::read_thinnings(given);
        const bool any = std::any_of(all.begin(), all.end(), [&](const check::Thinning& one) {
            return std::any_of(species.begin(), species.end(), [&](const check::StartingSpecies& of_run) {
                return of_run.species == one.species;
            });
        });
        if (!any) {
            config::fail(config::ExitCode::data, {given.file()},
                         joined("no thinning of a species of run ", runs_.text(row_, "run")),
                         joined("a row for ", runs_.text(row_, "species")),
                         "spell species alike in all tables, or write `no` under thinned");
        }
        return all;
    }

    const CaseFiles& files_;
    const config::Table& runs_;
    std::size_t row_;
};

/// Months from the first of a run on of a row: by `date` (2001-01 or 2001-01-31), by `year` and `month`, or
/// by `month_number`, 0 for the first.
std::optional<int> month_of(const config::Table& table, std::size_t row, const check::Site& site,
                            config::Problems& problems) {
    if (table.has("date")) {
        const std::string& text = table.text(row, "date");
        const std::vector<std::string> parts = between(text, '-');
        const auto year = parts.size() >= 2 ? config::parse_whole(parts[0]) : std::nullopt;
        const auto month = parts.size() >= 2 ? config::parse_whole(parts[1]) : std::nullopt;
        if (parts.size() > 3 || !year || *year < 0 || *year > 9999 || !month || *month < 1 || *month > 12) {
            problems.add(config::ExitCode::data, table.place(row, "date"),
                         joined("date ", config::in_quotes(text)), "a date such as 2001-01-31 or 2001-01");
            return std::nullopt;
        }
        return check::YearMonth{static_cast<int>(*year), static_cast<int>(*month)}.count() -
               site.from.count();
    }
    if (table.has("month_number")) {
        const auto number = table.whole(row, "month_number", {0.0, 1e5}, problems);
        return number ? std::optional{static_cast<int>(*number)} : std::nullopt;
    }
    const auto year = table.whole(row, "year", {0.0, 9999.0}, problems);
    const auto month = table.whole(row, "month", {1.0, 12.0}, problems);
    return year && month
               ? std::optional{check::YearMonth{static_cast<int>(*year), static_cast<int>(*month)}.count() -
                               site.from.count()}
               : std::nullopt;
}

/// The species of a row by its place in the run; that of a run with one species where none is named.
std::optional<std::size_t> species_in_run(const config::Table& table, std::size_t row,
                                          const check::Inputs& inputs, config::Problems& problems) {
    if (!table.has("species")) {
        return 0;
    }
    std::vector<std::string> names;
    for (const check::StartingSpecies& species : inputs.species) {
        names.push_back(species.species);
    }
    const auto found = std::find(names.begin(), names.end(), table.text(row, "species"));
    if (found == names.end()) {
        std::string list;
        for (const std::string& name : names) {
            list += joined(list.empty() ? "" : " or ", name);
        }
        problems.add(config::ExitCode::data, table.place(row, "species"),
                     joined("species ", config::in_quotes(table.text(row, "species"))),
                     joined("a species of the run: ", list));
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - names.begin());
}

void check_columns(const config::Table& table, const check::Inputs& inputs, config::Problems& problems) {
    if (table.has("year") || table.has("month")) {
        if (!table.has("date") && !table.has("month_number")) {
            table.require({"year", "month"}, problems);
        }
    } else if (!table.has("month_number")) {
        table.require({"date"}, problems);  // the usual one: a misspelt `date` is found as such
    }
    if (inputs.species.size() > 1) {
        table.require({"species"}, problems);
    }
    if (table.rows() == 0) {
        problems.add(config::ExitCode::data, {table.file()}, "no rows", "a row for each month and species");
    }
    problems.throw_if_any();
}

/// " of 2015" where the year has a column of its own.
std::string in_year(const config::Table& table, std::size_t row) {
    return !table.has("date") && !table.has("month_number") && table.has("year")
               ? joined(" of ", table.text(row, "year"))
               : "";
}

/// For each row of a reference the row of our run with its month and species.
std::vector<std::size_t> rows_in_run(const config::Table& table, const check::Inputs& inputs) {
    config::Problems problems;
    check_columns(table, inputs, problems);
    const int months = inputs.site.to.count() - inputs.site.from.count() + 1;
    std::vector<std::size_t> rows;
    std::map<std::size_t, std::size_t> seen;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::optional<int> month = month_of(table, row, inputs.site, problems);
        const std::optional<std::size_t> species = species_in_run(table, row, inputs, problems);
        if (!month || !species) {
            continue;
        }
        const std::string column = table.has("date")           ? "date"
                                   : table.has("month_number") ? "month_number"
                                                               : "month";
        if (*month < 0 || *month >= months) {
            problems.add(config::ExitCode::data, table.place(row, column),
                         joined(column, " ", table.text(row, column), in_year(table, row),
                                ", which is not in the run"),
                         joined("a month from the first to the last of the site (", std::to_string(months),
                                " months)"),
                         "leave the row out, or correct `from` and `to` of the site");
            continue;
        }
        rows.push_back(static_cast<std::size_t>(*month) * inputs.species.size() + *species);
        if (const auto [first, is_new] = seen.emplace(rows.back(), row); !is_new) {
            problems.add(config::ExitCode::data, table.place(row, column),
                         joined("the month and species of line ",
                                std::to_string(table.place(first->second, column).line), " a second time"),
                         "each once", "leave one of the rows out");
        }
    }
    problems.throw_if_any();
    return rows;
}

/// A run with other parameters or weather than its reference had differs for no fault of the model.
void warn_of_defaults(const config::Table& parameters, const config::Table& climate,
                      config::Warnings& warnings) {
    const std::vector<std::string> filled = check::defaults_in(parameters);
    if (!filled.empty()) {
        std::string list;
        for (const std::string& one : filled) {
            list += joined(list.empty() ? "" : ", ", one);
        }
        warnings.add(joined(
            parameters.file(), ": ", std::to_string(filled.size()),
            filled.size() == 1 ? " parameter has no row and takes" : " parameters have no row and take",
            " the default of r3PG: ", list, "; add the rows if the reference was made with other values"));
    }
    if (!climate.has("co2")) {
        warnings.add(joined(climate.file(),
                            ": no column co2, 350 ppm in all months; add the column if the "
                            "reference was made with other values"));
    }
}

/// Warns of each table once, however many runs it has.
void look_at_inputs(const RunRow& reader, const ReferenceRun& run, std::set<std::string>& looked_at,
                    config::Warnings& warnings) {
    const config::Table site = reader.site();
    const config::Table start = reader.start();
    const config::Table climate = reader.climate();
    check_latitude(site, climate, run.inputs);
    if (looked_at.insert(site.file()).second) {
        warn_of_site(site, warnings);
    }
    if (looked_at.insert(start.file()).second) {
        warn_of_start(start, warnings);
    }
    if (looked_at.insert(climate.file()).second) {
        warn_of_climate(climate, run.inputs.climate, warnings);
    }
    note_late_planting(run.name, run.inputs, warnings);
}

/// Each run has a name of its own, and its reference is there.
void check_rows_of_runs(const CaseFiles& files, const config::Table& table, config::Problems& problems) {
    std::vector<std::string> present;
    for (const auto& [name, text] : files.texts) {
        present.push_back(name);
    }
    std::set<std::string> names;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        if (!names.insert(table.text(row, "run")).second) {
            problems.add(config::ExitCode::data, table.place(row, "run"),
                         joined("run ", config::in_quotes(table.text(row, "run")), " a second time"),
                         "a name of its own for each run");
        }
        const std::string& reference = table.text(row, "reference");
        if (!files.has(reference)) {
            const std::string nearest = config::nearest_word(reference, present);
            problems.add(config::ExitCode::file, table.place(row, "reference"),
                         joined("no file ", config::in_quotes(reference), " in ", files.folder),
                         nearest.empty() ? "the results of the other program" : config::in_quotes(nearest));
        }
    }
}

}  // namespace

std::size_t rows_of(const plain_3pg::Inputs& inputs) {
    return inputs.species.size() *
           static_cast<std::size_t>(inputs.site.to.count() - inputs.site.from.count() + 1);
}

std::vector<ReferenceRun> read_reference_runs(const CaseFiles& files, config::Warnings& warnings) {
    const config::Table table = files.table("runs.csv");
    config::Problems problems;
    warn_of_unknown_columns(table,
                            {"run", "species", "models", "reference", "height", "thinned", "floor", "site",
                             "start", "parameters", "climate", "thinning"},
                            warnings);
    std::set<std::string> looked_at;  // files of several runs, which one warning is enough for
    if (!table.require({"run", "species", "models", "reference", "source"}, problems)) {
        problems.throw_if_any();
    }
    check_rows_of_runs(files, table, problems);
    problems.throw_if_any();
    std::vector<ReferenceRun> runs;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const RunRow reader{files, table, row};
        ReferenceRun run{table.text(row, "run"),
                         reader.inputs(),
                         reader.settings(problems),
                         files.table(table.text(row, "reference")),
                         {},
                         1e-7,
                         table.text(row, "source"),
                         reader.parameters().file()};
        if (table.has("floor") && !table.text(row, "floor").empty()) {
            run.floor = table.number(row, "floor", {.low = 1e-12, .high = 1e3}, problems).value_or(1.0);
        }
        run.row_in_run = rows_in_run(run.table, run.inputs);
        run.compared = compared_columns(run);
        if (looked_at.insert(run.table.file()).second) {
            warn_of_unknown_columns(run.table, known_columns(), warnings);
        }
        look_at_inputs(reader, run, looked_at, warnings);
        if (looked_at.insert(run.parameters_file).second) {
            warn_of_defaults(reader.parameters(), reader.climate(), warnings);
        }
        runs.push_back(std::move(run));
    }
    if (runs.empty()) {
        problems.add(config::ExitCode::data, {table.file()}, "no run", "one row or more");
    }
    problems.throw_if_any();
    return runs;
}

}  // namespace coupling::validation::forest_cases
