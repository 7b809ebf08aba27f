#include "coupling/exchange/regimes/rows.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "config/options/values.hpp"
#include "config/text/joined.hpp"
#include "config/text/reading.hpp"
#include "coupling/exchange/regimes/columns.hpp"
#include "coupling/exchange/regimes/known_columns.hpp"

namespace coupling {
namespace {

using config::joined;

/// Words that foresters use for what has another name here.
struct Synonym {
    std::string_view word;
    std::string_view here;
};
constexpr Synonym synonyms[] = {{"slit_cut", "'clear_cut' with where = slits"},
                                {"strip_clear", "'clear_cut' with where = strips"},
                                {"strip_cut", "'clear_cut' with where = strips"},
                                {"strip_shelterwood", "'shelter_cut' with where = strips, then 'clear_cut'"},
                                {"shelterwood", "'shelter_cut', then 'clear_cut'"},
                                {"seed_cut", "'shelter_cut'"},
                                {"clearance", "'clear_cut'"},
                                {"plenter", "'selection'"},
                                {"crop_trees", "'thin_crop_trees'"}};

/// Words between commas and semicolons; without any, between blanks.
std::vector<std::string> words_in(std::string_view text, std::string_view separators) {
    std::vector<std::string> words;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of(separators), text.size());
        if (const std::string_view word = config::trimmed(text.substr(0, end)); !word.empty()) {
            words.emplace_back(word);
        }
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return words;
}

/// Reads the rows one after the other.
class RowReader {
public:
    RowReader(const config::Table& table, const forest::SpeciesTable& species, config::Problems& problems)
        : table_{table}, species_{species}, problems_{problems} {}

    std::vector<Intervention> all() {
        std::vector<Intervention> rows;
        for (std::size_t row = 0; row < table_.rows(); ++row) {
            std::optional<Intervention> intervention = read(row, rows);
            if (intervention) {
                rows.push_back(std::move(*intervention));
            } else {
                refused_.push_back(table_.text(row, table_.has("name") ? "name" : "treatment"));
            }
        }
        return rows;
    }

private:
    std::optional<Intervention> read(std::size_t row, const std::vector<Intervention>& above) {
        row_ = row;
        fine_ = true;
        Intervention intervention;
        intervention.place = table_.place(row, table_.columns().front());
        intervention.place.column = 0;
        // Treatment and place say which other fields mean something.
        set(intervention, "treatment");
        const bool known = fine_;
        set(intervention, "where");
        set(intervention, "after");
        if (intervention.ground.where == Where::cuts_of) {
            find_cuts(intervention, above);
        }
        if (!intervention.after.empty()) {
            follow(intervention, above);
        }
        if (!known) {
            return std::nullopt;
        }
        for (const RegimeColumn& column : regime_columns()) {
            if (column.name != "treatment" && column.name != "where" && column.name != "after") {
                set(intervention, column);
            }
        }
        name(intervention, above);
        if (fine_) {
            check(intervention);
        }
        return fine_ ? std::optional{intervention} : std::nullopt;
    }

    void set(Intervention& intervention, std::string_view name) {
        set(intervention, *std::find_if(regime_columns().begin(), regime_columns().end(),
                                        [name](const RegimeColumn& column) { return column.name == name; }));
    }

    void set(Intervention& intervention, const RegimeColumn& column) {
        const std::string name{column.name};
        const bool empty = !table_.has(name) || table_.text(row_, name).empty();
        const bool followed = !intervention.after.empty() && is_ground(column);
        if (!is_used(column, intervention) || followed) {
            if (!empty && followed && intervention.ground.where != Where::cuts_of) {
                refuse(name, joined(name, " = ", config::in_quotes(table_.text(row_, name))),
                       "nothing: a row with `after` acts on the ground of the row it follows");
            } else if (!empty) {
                const bool of_place = column.rules.places != 0 && column.rules.treatments == 0;
                refuse(name, joined(name, " = ", config::in_quotes(table_.text(row_, name))),
                       joined("no value here: ",
                              of_place ? joined("where = ", name_of(intervention.ground.where))
                                       : name_of(intervention.treatment),
                              " has no column ", name, ", it belongs to ", users_text(column)));
            }
            return;
        }
        if (empty) {
            if (column.rules.needed) {
                refuse(
                    table_.has(name) ? name : table_.columns().front(), joined("no ", name),
                    joined("a value for ", name, ", which ",
                           column.rules.places != 0 ? joined("where = ", name_of(intervention.ground.where))
                           : name == "treatment"    ? std::string{"each row"}
                                                    : name_of(intervention.treatment),
                           " needs"));
            }
            return;
        }
        std::visit([&](auto field) { read_into(field(intervention), name, column.rules.range); },
                   column.field);
    }

    static bool is_ground(const RegimeColumn& column) {
        return column.name == "where" || column.rules.places != 0;
    }

    template <class T>
    void read_into(T& target, const std::string& name, const config::NumberRange& range) {
        const std::string& text = table_.text(row_, name);
        if constexpr (std::is_same_v<T, bool>) {
            keep(target, config::flag_in(text), name, "yes or no");
        } else if constexpr (std::is_same_v<T, std::string>) {
            target = text;
        } else if constexpr (std::is_same_v<T, config::Angle>) {
            double degrees = 0.0;
            read_into(degrees, name, range);
            target = config::Angle::from_degrees(degrees);
        } else if constexpr (std::is_same_v<T, double> || std::is_same_v<T, std::optional<double>>) {
            keep(target, config::number_in(text, range), name, config::describe("a number", range));
        } else if constexpr (std::is_same_v<T, int> || std::is_same_v<T, std::size_t> ||
                             std::is_same_v<T, std::optional<int>>) {
            const std::optional<long long> whole = config::parse_whole(text);
            const bool good = whole && range.contains(static_cast<double>(*whole));
            keep(target, good ? std::optional{static_cast<int>(*whole)} : std::nullopt, name,
                 config::describe("a whole number", range));
        } else if constexpr (std::is_same_v<T, std::vector<double>>) {
            keep(target, config::numbers_in(text, range), name,
                 config::describe("numbers with blanks between, each", range));
        } else if constexpr (std::is_same_v<T, std::vector<std::uint32_t>>) {
            for (const std::string& word : words_in(text, " ,;")) {
                const auto number = config::count_in(word, range);
                if (!number) {
                    refuse(name, config::in_quotes(word), "whole numbers with blanks between");
                } else {
                    target.push_back(static_cast<std::uint32_t>(*number));
                }
            }
        } else if constexpr (std::is_same_v<T, std::vector<forest::SpeciesId>>) {
            read_species(target, text, name);
        } else if constexpr (std::is_same_v<T, Treatment>) {
            read_word(target, treatment_count, text, name);
        } else {
            static_assert(std::is_same_v<T, Where>);
            const std::string word{config::trimmed(std::string_view{text}.substr(0, text.find(':')))};
            read_word(target, where_count, word == name_of(Where::cuts_of) ? word : text, name);
        }
    }

    template <class T, class Value>
    void keep(T& target, const std::optional<Value>& value, const std::string& name, std::string expected) {
        if (value) {
            if constexpr (std::is_same_v<T, std::size_t>) {
                target = static_cast<std::size_t>(*value);
            } else {
                target = *value;
            }
        } else {
            refuse(name, joined(name, " = ", config::in_quotes(table_.text(row_, name))),
                   std::move(expected));
        }
    }

    template <class Enum>
    void read_word(Enum& target, std::size_t count, const std::string& text, const std::string& name) {
        std::vector<std::string> words;
        for (std::size_t i = 0; i < count; ++i) {
            words.push_back(name_of(static_cast<Enum>(i)));
            if (words.back() == text) {
                target = static_cast<Enum>(i);
                return;
            }
        }
        std::string expected;
        for (const Synonym& synonym : synonyms) {
            if (synonym.word == text) {
                expected = synonym.here;
            }
        }
        const std::string nearest = config::nearest_word(text, words);
        if (expected.empty() && !nearest.empty()) {
            expected = config::in_quotes(nearest);
        }
        if (expected.empty()) {
            for (const std::string& word : words) {
                expected.append(expected.empty() ? "one of " : ", ").append(word);
            }
        }
        refuse(name, joined(name, " ", config::in_quotes(text)), expected);
    }

    void read_species(std::vector<forest::SpeciesId>& target, const std::string& text,
                      const std::string& name) {
        const bool parted = text.find_first_of(",;") != std::string::npos;
        const std::vector<std::string> words =
            species_.find(text) ? std::vector{text} : words_in(text, parted ? ",;" : " ");
        for (const std::string& word : words) {
            const auto found = species_.find(word, table_.place(row_, name), problems_);
            fine_ = fine_ && found.has_value();
            if (found && std::find(target.begin(), target.end(), *found) != target.end()) {
                refuse(name, joined("species ", config::in_quotes(word), " a second time"),
                       "each species once");
            } else if (found) {
                target.push_back(*found);
            }
        }
    }

    /// The row of that name above; a problem, or one reported already, where there is none.
    const Intervention* row_above(const std::string& wanted, const std::string& column,
                                  const std::vector<Intervention>& above) {
        std::vector<std::string> names;
        for (const Intervention& earlier : above) {
            if (earlier.name == wanted) {
                return &earlier;
            }
            names.push_back(earlier.name);
        }
        if (std::find(refused_.begin(), refused_.end(), wanted) != refused_.end()) {
            fine_ = false;
            return nullptr;
        }
        const std::string nearest = config::nearest_word(wanted, names);
        refuse(column, joined(column, " ", config::in_quotes(table_.text(row_, column))),
               nearest.empty()     ? "the name of a row above it"
               : column == "where" ? config::in_quotes(joined("cuts_of:", nearest))
                                   : config::in_quotes(nearest));
        return nullptr;
    }

    bool is_given(const std::string& column) const {
        return table_.has(column) && !table_.text(row_, column).empty();
    }

    /// where = cuts_of:ROW. Without any time of its own the row comes in the year of the cut, or after_years
    /// later.
    void find_cuts(Intervention& intervention, const std::vector<Intervention>& above) {
        const std::string& text = table_.text(row_, "where");
        const std::size_t colon = text.find(':');
        const std::string wanted{
            colon == std::string::npos ? "" : config::trimmed(std::string_view{text}.substr(colon + 1))};
        if (wanted.empty()) {
            refuse("where", joined("where ", config::in_quotes(text)),
                   "cuts_of:ROW with the name of a row above it that cuts");
            return;
        }
        const Intervention* source = row_above(wanted, "where", above);
        if (source == nullptr) {
            return;
        }
        if (!source->leaves_ground()) {
            refuse(
                "where",
                joined("where ", config::in_quotes(text), ": ", wanted, " is a ", name_of(source->treatment)),
                "a row above it that cuts trees or salvages");
            return;
        }
        intervention.ground.cuts_of = wanted;
        const std::vector<std::string> times{"first_year", "every_years", "last_year", "from_age_years",
                                             "to_age_years"};
        if (intervention.after.empty() &&
            std::none_of(times.begin(), times.end(), [&](const std::string& c) { return is_given(c); })) {
            intervention.after = wanted;
        }
    }

    /// A row with `after` acts where the row it follows acted: of a group cut in its holes.
    void follow(Intervention& intervention, const std::vector<Intervention>& above) {
        const bool on_cuts = intervention.ground.where == Where::cuts_of;
        if (!on_cuts && is_given("where")) {
            refuse("where", joined("where = ", config::in_quotes(table_.text(row_, "where"))),
                   "nothing beside `after`: the row acts where the row it follows acted; or where = "
                   "cuts_of:ROW");
        }
        const Intervention* earlier = row_above(intervention.after, "after", above);
        if (earlier == nullptr) {
            return;
        }
        if (!on_cuts) {
            intervention.ground = earlier->ground;
            if (earlier->treatment == Treatment::group_cut) {
                intervention.ground = {.where = Where::cuts_of, .cuts_of = earlier->name};
            }
        } else if (earlier->name != intervention.ground.cuts_of &&
                   earlier->ground.cuts_of != intervention.ground.cuts_of) {
            refuse("after",
                   joined("after ", config::in_quotes(intervention.after),
                          " beside where = cuts_of:", intervention.ground.cuts_of),
                   joined("after = ", intervention.ground.cuts_of, ", or a row that acts on the same cuts"));
        }
    }

    void name(Intervention& intervention, const std::vector<Intervention>& above) {
        const bool given = !intervention.name.empty();
        intervention.name = given ? intervention.name : name_of(intervention.treatment);
        for (const Intervention& earlier : above) {
            if (earlier.name == intervention.name) {
                refuse(given ? "name" : "treatment",
                       joined("a second row with the name ", config::in_quotes(intervention.name)),
                       "a name of its own in the column `name`");
            }
        }
    }

    /// The list says when and where.
    void check_list_alone() {
        for (const char* column :
             {"first_year", "every_years", "last_year", "after", "after_years", "where", "from_age_years",
              "to_age_years", "from_dominant_height_m", "from_basal_area_m2pha", "from_relative_density",
              "from_damage_m3pha", "from_gap_m", "to_gap_m", "stands", "from_slope_deg", "to_slope_deg"}) {
            if (is_given(column)) {
                refuse(column, joined(column, " = ", config::in_quotes(table_.text(row_, column))),
                       "no value here: the file in `trees` says which trees are felled and when");
            }
        }
    }

    /// What fields of one row say together.
    void check(const Intervention& i) {
        if (i.last_year && *i.last_year < i.first_year) {
            refuse("last_year", joined("last_year ", std::to_string(*i.last_year)),
                   joined("first_year (", std::to_string(i.first_year), ") or later"));
        }
        if (i.from_age_years && i.to_age_years && *i.to_age_years <= *i.from_age_years) {
            refuse("to_age_years", joined("to_age_years ", config::to_text(*i.to_age_years)),
                   joined("more than from_age_years (", config::to_text(*i.from_age_years), ")"));
        }
        if (i.after.empty() && i.ground.entries > 1 && !i.every_years) {
            refuse("entries", joined(std::to_string(i.ground.entries), " entries without every_years"),
                   "the years from one entry to the next in every_years");
        }
        if (!i.after.empty() &&
            (i.every_years || (table_.has("first_year") && !table_.text(row_, "first_year").empty()))) {
            refuse("after", "first_year or every_years beside `after`",
                   "after_years alone: the row it follows says when");
        }
        if (i.after.empty() && i.after_years > 0) {
            refuse("after_years", "after_years without `after`", "the name of a row above it in `after`");
        }
        if (i.treatment == Treatment::fell_list) {
            check_list_alone();
        }
        if (i.treatment == Treatment::plant && i.plants_pha.size() != i.species.size()) {
            refuse("plants_pha",
                   joined(std::to_string(i.plants_pha.size()), " numbers for ",
                          std::to_string(i.species.size()), " species"),
                   "one for each species");
        }
        if (i.treatment == Treatment::plant_clusters && i.species.size() != 1) {
            refuse("treatment", joined(std::to_string(i.species.size()), " species for clusters"),
                   "one species");
        }
        if (i.treatment == Treatment::tend && i.species.empty()) {
            refuse("treatment", "tending without favoured species", "at least one in the column `species`");
        }
        if (i.treatment == Treatment::target_diameter && i.from_dbh_cm <= 0.0) {
            refuse("treatment", "target_diameter without from_dbh_cm", "a diameter above 0");
        }
        if (std::fmod(i.spacing_m, forest::patch_side_m) != 0.0) {
            refuse("spacing_m", joined("spacing_m ", config::to_text(i.spacing_m)), "a multiple of 10 m");
        }
        if (i.ground.from_slope_deg > i.ground.to_slope_deg) {
            refuse("from_slope_deg", joined("from_slope_deg ", config::to_text(i.ground.from_slope_deg)),
                   joined("at most to_slope_deg (", config::to_text(i.ground.to_slope_deg), ")"));
        }
        for (const forest::SpeciesId species : i.only_species) {
            if (std::find(i.spare_species.begin(), i.spare_species.end(), species) != i.spare_species.end()) {
                refuse("spare_species", "a species in only_species and in spare_species", "one of the two");
            }
        }
        if (i.from_height_m > i.to_height_m) {
            refuse("from_height_m", joined("from_height_m ", config::to_text(i.from_height_m)),
                   joined("at most to_height_m (", config::to_text(i.to_height_m), ")"));
        }
    }

    void refuse(std::string_view column, std::string found, std::string expected) {
        fine_ = false;
        const std::string name{table_.has(column) ? column : std::string_view{table_.columns().front()}};
        problems_.add(config::ExitCode::data, table_.place(row_, name), std::move(found),
                      std::move(expected));
    }

    const config::Table& table_;
    const forest::SpeciesTable& species_;
    config::Problems& problems_;
    std::vector<std::string> refused_;  ///< names of rows with problems
    std::size_t row_ = 0;
    bool fine_ = true;
};

}  // namespace

std::vector<Intervention> read_interventions(const config::Table& table, const forest::SpeciesTable& species,
                                             config::Problems& problems) {
    refuse_unknown_columns(table, problems);
    if (!table.require({"treatment"}, problems)) {
        return {};
    }
    return RowReader{table, species, problems}.all();
}

}  // namespace coupling
