#include "validation/engine/kinds/validation_case.hpp"

#include <algorithm>
#include <sstream>

#include "config/table/table.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/words_of_list.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "validation/engine/field/field_case.hpp"
#include "validation/engine/field/field_states.hpp"
#include "validation/engine/kinds/collapse_case.hpp"
#include "validation/engine/kinds/forest_case.hpp"
#include "validation/engine/kinds/scenario_changes.hpp"

namespace coupling::validation {
namespace {

using config::joined;

/// Reads the tables of a case one after the other and collects what is wrong in any of them.
class CaseReader {
public:
    explicit CaseReader(ValidationCase& out) : out_{out} {}

    /// The files of a case with rocks.
    void read(const Recipe& recipe) {
        read_profile_file(recipe);
        read_sections();
        FigureFrame frame;
        frame.sections = out_.sections;
        for (const Station& station : recipe.stations) {
            frame.stations.push_back(station.name);
        }
        check_stations(recipe);
        if (out_.kind != CaseKind::factors) {
            names_ = figure_names(frame, recipe.has_stand());
        }
        read_criteria();
        read_falls(recipe);
        problems_.throw_if_any();
    }

    /// The files of a case that is a comparison, which has read its own.
    void read(const Comparison& comparison) {
        for (const Figure& figure : comparison.figures) {
            names_.push_back(figure.name);
        }
        comparison_ = &comparison;
        read_criteria();
        for (const auto& [name, reference] : comparison.references) {
            out_.published[name] = {reference.value, {}, {}, reference.source};
        }
        for (const Figure& figure : comparison.figures) {
            if (figure.listed && comparison.references.contains(figure.name)) {
                add_figure(figure.name);
            }
        }
        problems_.throw_if_any();
        if (out_.criteria.empty()) {
            show_without_criteria(comparison);
        }
    }

private:
    /// Figures help without bounds too; but nobody should take their list for a verdict.
    void show_without_criteria(const Comparison& comparison) {
        for (const Figure& figure : comparison.figures) {
            if (figure.listed) {
                add_figure(figure.name);
            }
        }
        out_.warnings.push_back(
            joined("nothing is judged: ", out_.files.shown("criteria.csv"),
                   out_.files.has("criteria.csv") ? " has no row" : " is missing",
                   "; write a row for each figure that must stay within bounds (validation/README.md)"));
    }

    void read_criteria() {
        table("criteria.csv", {"quantity", "low", "high", "rests_on", "rule"},
              [this](const config::Table& t, std::size_t row) { read_criterion(t, row); });
    }

    void read_falls(const Recipe& recipe) {
        table("observed.csv", {"quantity", "value", "source"},
              [this](const config::Table& t, std::size_t row) { read_observed(t, row); });
        table("published.csv", {"quantity", "value", "deviation", "series", "source"},
              [this](const config::Table& t, std::size_t row) { read_published(t, row); });
        out_.variants = {{"strict", "strict", {}, "exactly what the paper states"},
                         {"default", "default", {}, "our best settings"}};
        table("variants.csv", {"variant", "preset", "overrides", "meaning"},
              [&](const config::Table& t, std::size_t row) { read_variant(t, row, recipe); });
        table("choices.csv", {"choice", "overrides", "reason"},
              [&](const config::Table& t, std::size_t row) { read_choice(t, row, recipe); });
    }

    template <class Row>
    void table(const std::string& file, const std::vector<std::string>& columns, Row read_row) {
        if (!out_.files.has(file)) {
            return;
        }
        try {
            const config::Table rows = out_.files.table(file);
            if (!rows.require(columns, problems_)) {
                return;
            }
            for (std::size_t row = 0; row < rows.rows(); ++row) {
                read_row(rows, row);
            }
        } catch (const config::InputError& error) {
            problems_.add(error);
        }
    }

    void refuse(const config::Table& table, std::size_t row, const std::string& column,
                std::string expected) {
        problems_.add(config::ExitCode::data, table.place(row, column),
                      config::in_quotes(table.text(row, column)), std::move(expected));
    }

    void read_profile_file(const Recipe& recipe) {
        if (out_.kind == CaseKind::factors) {
            return;
        }
        try {
            profile_ = out_.profile(recipe);
        } catch (const config::InputError& error) {
            problems_.add(error);
        }
        if (out_.replaces_profile()) {
            out_.notes.push_back(joined(recipe.profile, " replaced by ", out_.changes.profile_file));
        }
    }

    void read_sections() {
        table("sections.csv", {"section", "from_m", "to_m"}, [this](const config::Table& t, std::size_t row) {
            const auto from_m = t.number(row, "from_m", {}, problems_);
            const auto to_m = t.number(row, "to_m", {}, problems_);
            if (from_m && to_m && *to_m <= *from_m) {
                refuse(t, row, "to_m", "a distance beyond from_m");
            }
            out_.sections.push_back({t.text(row, "section"), from_m.value_or(0.0), to_m.value_or(1.0)});
        });
    }

    void check_stations(const Recipe& recipe) {
        if (profile_.empty()) {
            return;
        }
        for (const Station& station : recipe.stations) {
            if (station.distance_m < profile_.front().distance_m ||
                station.distance_m > profile_.back().distance_m) {
                problems_.add(config::ExitCode::data, recipe.options->place_of("stations.distances_m"),
                              joined("station ", config::in_quotes(station.name), " at ",
                                     config::to_text(station.distance_m), " m"),
                              joined("a distance on the profile, which ends at ",
                                     config::to_text(profile_.back().distance_m), " m"));
            }
        }
    }

    /// The name of a figure that the program computes; "" with a problem for any other.
    std::string figure(const config::Table& table, std::size_t row) {
        const std::string& name = table.text(row, "quantity");
        if (comparison_ != nullptr && comparison_->unknown.contains(name)) {
            problems_.add(config::ExitCode::data, table.place(row, "quantity"),
                          joined(config::in_quotes(name),
                                 ", which cannot be computed: ", comparison_->unknown.at(name)),
                          "a figure of this case that has something to compare",
                          "add the data, or leave the row out");
            return "";
        }
        if (!names_.empty() && std::find(names_.begin(), names_.end(), name) == names_.end()) {
            const std::string nearest = config::nearest_word(name, names_);
            refuse(
                table, row, "quantity",
                !nearest.empty() ? config::in_quotes(nearest)
                : comparison_ != nullptr
                    ? joined("a figure of this kind of case (validation/README.md), such as ", names_.front())
                    : "a figure of `bannwald validate --help`, with a section, station or site "
                      "of this case where it needs one");
            return "";
        }
        add_figure(name);
        return name;
    }

    void add_figure(const std::string& name) {
        if (std::find(out_.figures.begin(), out_.figures.end(), name) == out_.figures.end()) {
            out_.figures.push_back(name);
        }
    }

    void read_criterion(const config::Table& t, std::size_t row) {
        const std::string name = figure(t, row);
        const auto low = t.number(row, "low", {}, problems_);
        const auto high = t.number(row, "high", {}, problems_);
        const std::string& rests_on = t.text(row, "rests_on");
        if (low && high && *high < *low) {
            refuse(t, row, "high", "a number not below low");
        }
        if (rests_on != "independent" && rests_on != "rebuilding" && rests_on != "fitted") {
            refuse(t, row, "rests_on", "independent, rebuilding or fitted");
        }
        if (low && high && !name.empty()) {
            const bool is_new = out_.criteria
                                    .emplace(name, Criterion{*low, *high, rests_on, t.text(row, "rule"),
                                                             t.has("cause") ? t.text(row, "cause") : ""})
                                    .second;
            if (!is_new) {
                refuse(t, row, "quantity", "one criterion for each figure");
            }
        }
    }

    void read_observed(const config::Table& t, std::size_t row) {
        const std::string name = figure(t, row);
        const auto value = t.number(row, "value", {}, problems_);
        if (value && !name.empty() &&
            !out_.observed.emplace(name, ObservedFigure{*value, t.text(row, "source")}).second) {
            refuse(t, row, "quantity", "one row for each figure");
        }
    }

    void read_published(const config::Table& t, std::size_t row) {
        const std::string name = figure(t, row);
        const auto value = t.number(row, "value", {}, problems_);
        std::optional<double> deviation;
        if (!t.text(row, "deviation").empty()) {
            deviation = t.number(row, "deviation", {.low = 0.0}, problems_);
        }
        if (!value || name.empty()) {
            return;
        }
        PublishedFigure& published = out_.published[name];
        const bool of_series = t.text(row, "series").find('x') != std::string::npos;
        if (of_series) {
            published.series_mean = value;
            published.deviation = deviation;
        } else {
            published.value = value;
            published.deviation = deviation ? deviation : published.deviation;
        }
        if (!published.value) {
            published.value = value;
        }
        if (published.source.empty()) {
            published.source = t.text(row, "source");
        }
    }

    /// Tries the overrides with a preset; what is wrong with them becomes a problem of the field.
    void try_out(const config::Table& t, std::size_t row, const std::string& preset,
                 const std::vector<std::string>& overrides, const Recipe& recipe) {
        try {
            const std::unique_ptr<Recipe> moved = out_.recipe(preset, overrides);
            if (moved->head.kind != out_.kind) {
                refuse(t, row, "overrides", "the kind of the case unchanged");
            } else if (out_.kind != CaseKind::factors && moved->profile != recipe.profile) {
                static_cast<void>(out_.profile(*moved));
            }
        } catch (const config::InputError& error) {
            for (const config::Problem& problem : error.problems()) {
                problems_.add(problem.code, t.place(row, "overrides"), problem.found, problem.expected,
                              problem.advice);
            }
        }
    }

    void read_variant(const config::Table& t, std::size_t row, const Recipe& recipe) {
        VariantSpec variant{t.text(row, "variant"), t.text(row, "preset"),
                            config::words_between_blanks(t.text(row, "overrides")), t.text(row, "meaning")};
        try_out(t, row, variant.preset, variant.overrides, recipe);
        const auto same = std::find_if(out_.variants.begin(), out_.variants.end(),
                                       [&](const VariantSpec& v) { return v.name == variant.name; });
        if (same == out_.variants.end()) {
            out_.variants.push_back(std::move(variant));
        } else if (same - out_.variants.begin() < 2) {
            *same = std::move(variant);  // a case may say more of strict and default
        } else {
            refuse(t, row, "variant", "a name of its own for each variant");
        }
    }

    void read_choice(const config::Table& t, std::size_t row, const Recipe& recipe) {
        ChoiceSpec choice{t.text(row, "choice"), config::words_between_blanks(t.text(row, "overrides")),
                          t.text(row, "reason")};
        const bool other_profile =
            std::any_of(choice.overrides.begin(), choice.overrides.end(),
                        [](const std::string& text) { return text.starts_with("terrain.profile="); });
        if (other_profile && out_.replaces_profile()) {
            out_.notes.push_back(joined("choice ", config::in_quotes(choice.name),
                                        " left out: the profile is the user's own"));
            return;
        }
        try_out(t, row, "strict", choice.overrides, recipe);
        out_.choices.push_back(std::move(choice));
    }

    ValidationCase& out_;
    const Comparison* comparison_ = nullptr;
    std::vector<std::string> names_;  ///< of figures that the case may speak of; any where empty
    Profile profile_;
    config::Problems problems_;
};

/// Fewer rocks of everything: no part of the case falls more than the large ensemble does.
void shrink(Recipe& recipe, std::uint64_t most_rocks) {
    recipe.rocks = most_rocks;
    recipe.choice_rocks = std::min(recipe.choice_rocks, most_rocks);
    recipe.rocks_per_series = std::min(recipe.rocks_per_series, std::max<std::uint64_t>(1, most_rocks / 2));
    recipe.series = std::min(recipe.series, most_rocks / recipe.rocks_per_series);
    recipe.stands = std::min(recipe.stands, most_rocks);
}

/// Settings that the user asks for are those of its scenario.
void read_field_case(ValidationCase& out) {
    config::Options options;
    FieldSettings settings;
    declare(options, out.head);
    options.text("field.scenario", settings.scenario,
                 {.meaning = "scenario of `bannwald run` in the folder of the case, with what was observed"});
    options.text(
        "field.states", settings.states,
        {.meaning = "instead of stops: CSV with state, overrides, meaning; what changes between them"});
    options.flag("field.first_impacts", settings.first_impacts,
                 {.meaning = "compare the first rebounds of each state, too"});
    options.flag("field.reach_angles", settings.reach_angles,
                 {.meaning = "compare the angles under which rocks of each state stop, too"});
    options.text("field.presets", settings.presets,
                 {.meaning = "presets, apart by blanks, that stand side by side for each state"});
    options.text("field.trends", settings.trends,
                 {.meaning = "CSV with trend, figure, states, source: orders that the states should have"});
    std::istringstream in{out.files.texts.at("case.ini")};
    options.read(in, out.files.shown("case.ini"), {});
    if (out.head.title.empty()) {
        config::fail(config::ExitCode::settings, options.place_of("case.title"), "no case.title",
                     "one line on what the case is");
    }
    out.comparison = std::make_shared<const Comparison>(
        settings.states.empty() ? read_field(out.files, settings, out.changes.overrides, out.notes)
                                : read_states(out.files, settings, out.changes.overrides));
}

}  // namespace

std::unique_ptr<Recipe> ValidationCase::recipe(const std::string& preset,
                                               const std::vector<std::string>& overrides) const {
    std::vector<std::string> all{joined("rockfall.preset=", preset)};
    // The user's own changes first: a variant or a choice stays what its name says.
    all.insert(all.end(), changes.overrides.begin(), changes.overrides.end());
    all.insert(all.end(), overrides.begin(), overrides.end());
    std::unique_ptr<Recipe> recipe = read_recipe(files, all);
    if (changes.most_rocks) {
        shrink(*recipe, *changes.most_rocks);
    }
    return recipe;
}

Profile ValidationCase::profile(const Recipe& recipe) const {
    if (replaces_profile()) {
        return read_profile(changes.profile_text, changes.profile_file);
    }
    const auto text = files.texts.find(recipe.profile);
    if (text == files.texts.end()) {
        config::fail(config::ExitCode::file, recipe.options->place_of("terrain.profile"),
                     joined("no file ", path_in_quotes(recipe.profile), " in ", files.folder),
                     "the profile of the slope");
    }
    return read_profile(text->second, files.shown(recipe.profile));
}

bool ValidationCase::needs_open() const {
    return std::any_of(figures.begin(), figures.end(), [](const std::string& name) {
        const auto figure = parse_figure(name);
        return figure && figure->cover != FigureName::Cover::as_is;
    });
}

std::string ValidationCase::label_of(const std::string& figure) const {
    const auto name = parse_figure(figure);
    return comparison ? comparison->figure(figure).label : name ? name->label() : "";
}

std::string ValidationCase::unit_of(const std::string& figure) const {
    const auto name = parse_figure(figure);
    return comparison ? comparison->figure(figure).unit : name ? name->unit() : "";
}

ValidationCase read_case(const CaseFiles& files, const CaseChanges& changes) {
    ValidationCase out;
    out.files = files;
    out.changes = changes;
    require_kind(files);
    out.kind = head_of(files).kind;
    if (out.kind == CaseKind::field || out.kind == CaseKind::collapse) {
        take_changes_of_a_scenario(out);
    }
    if (is_forest(out.kind)) {
        read_forest(out);
    } else if (out.kind == CaseKind::field) {
        read_field_case(out);
    } else if (out.kind == CaseKind::collapse) {
        out.comparison = std::make_shared<const Comparison>(
            read_collapse_case(out.files, out.head, out.changes.overrides));
    }
    if (out.comparison) {
        CaseReader{out}.read(*out.comparison);
        return out;
    }
    const std::unique_ptr<Recipe> recipe = out.recipe("default");
    for (const config::Renaming& renaming : recipe->options->renamings()) {
        out.notes.push_back(to_string(renaming));
    }
    out.kind = recipe->head.kind;
    out.head = recipe->head;
    CaseReader{out}.read(*recipe);
    return out;
}

}  // namespace coupling::validation
