#include "coupling/inputs/plausible/repeated_trees.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>
#include <unordered_map>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/text/reading.hpp"
#include "coupling/inputs/plausible/close_trees.hpp"

namespace coupling::plausible {
namespace {

using config::joined;

constexpr double some =
    0.05;  // [choice] slips of single trees are fewer, a second census is half of the list
constexpr std::size_t few = 5;  // [choice] fewer rows are slips in lists of any length
constexpr std::size_t most_censuses = 100;

constexpr std::array read_columns{"tree_id", "x_m", "y_m",         "species",   "dbh_cm",  "height_m",
                                  "state",   "wkt", "broken_at_m", "age_years", "strength"};

/// Parts of the names of columns that distinguish censuses.
constexpr std::array<std::string_view, 22> census_words{
    "year",  "jahr",   "annee", "année",   "anno",     "period",   "date",      "datum",
    "data",  "census", "cens",  "campagn", "aufnahme", "inventur", "inventory", "survey",
    "visit", "epoch",  "zeit",  "time",    "measure",  "rilievo"};

/// Parts of the names of columns that number the stems of one tree: those stand on one spot rightly.
constexpr std::array<std::string_view, 6> stem_words{"stem", "stamm", "shoot", "tige", "fusto", "pollone"};

/// Columns that say with yes or no whether a tree is gone, and those that say it with a word.
constexpr std::array<std::string_view, 18> gone_columns{
    "removed",   "harvested", "cut",      "felled",  "dead",          "thinned",
    "entnommen", "entnahme",  "gefaellt", "gefällt", "tot",           "enleve",
    "enlevé",    "coupe",     "mort",     "rimosso", "ausgeschieden", "abgestorben"};
constexpr std::array<std::string_view, 14> status_columns{
    "status", "statut", "stato", "condition",  "zustand", "treestatus", "tree_status",
    "etat",   "état",   "fate",  "baumstatus", "lebend",  "alive",      "living"};
constexpr std::array<std::string_view, 17> yes_words{"true", "1",    "1.0",  "yes", "y",  "t",
                                                     "ja",   "j",    "oui",  "si",  "sì", "x",
                                                     "wahr", "vrai", "vero", "on",  "w"};
constexpr std::array<std::string_view, 9> no_words{"false", "0",   "0.0",    "no",  "n",
                                                   "nein",  "non", "falsch", "faux"};
constexpr std::array<std::string_view, 24> gone_words{
    "removed",   "cut",     "felled",   "harvested", "dead",        "gone",          "thinned", "missing",
    "entnommen", "gefällt", "gefaellt", "tot",       "abgestorben", "ausgeschieden", "mort",    "coupé",
    "coupe",     "enlevé",  "morto",    "abbattuto", "tagliato",    "rimosso",       "died",    "abattu"};

template <class List>
bool is_in(const List& list, std::string_view word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

std::vector<std::string> unread_columns(const config::Table& table) {
    std::vector<std::string> columns;
    for (const std::string& column : table.columns()) {
        if (!is_in(read_columns, column)) {
            columns.push_back(column);
        }
    }
    return columns;
}

/// Numbers rows of one tree alike: those with the same fields.
class Trees {
public:
    Trees(const config::Table& table, const std::vector<const char*>& fields) {
        std::unordered_map<std::string, std::size_t> known;
        std::string key;
        for (std::size_t row = 0; row < table.rows(); ++row) {
            key.clear();
            for (const char* field : fields) {
                const std::string& text = table.text(row, field);
                const auto number = config::parse_number(text);
                // The same number may be written in several ways. What begins a field parts both kinds.
                if (number) {
                    const auto bytes = std::bit_cast<std::array<char, sizeof(double)>>(*number);
                    key += '\1';
                    key.append(bytes.data(), bytes.size());
                } else {
                    key += '\2';
                    key += text;
                    key += '\0';  // in no field of a text file
                }
            }
            tree_of_.push_back(known.emplace(key, known.size()).first->second);
        }
        trees_ = known.size();
    }
    [[nodiscard]] std::size_t again() const { return tree_of_.size() - trees_; }
    /// Rows that have the tree and the value of an earlier one.
    [[nodiscard]] std::size_t again_with(const config::Table& table, const std::string& column) const {
        std::set<std::pair<std::size_t, std::string>> seen;
        for (std::size_t row = 0; row < tree_of_.size(); ++row) {
            seen.emplace(tree_of_[row], table.seen_text(row, column));
        }
        return tree_of_.size() - seen.size();
    }

private:
    std::vector<std::size_t> tree_of_;
    std::size_t trees_ = 0;
};

std::vector<std::string> values_of(const config::Table& table, const std::string& column) {
    std::set<std::string> values;
    for (std::size_t row = 0; row < table.rows() && values.size() <= most_censuses; ++row) {
        values.insert(table.seen_text(row, column));
    }
    return {values.begin(), values.end()};
}

/// The column whose values make the rows of each tree different ones; those with a telling name first, then
/// those with the fewest values.
void find_census(const config::Table& table, const Trees& trees, RepeatedTrees& found) {
    std::optional<std::tuple<bool, std::size_t, std::string>> best;
    for (const std::string& column : unread_columns(table)) {
        std::vector<std::string> values = values_of(table, column);
        if (values.size() < 2 || values.size() > most_censuses ||
            static_cast<double>(trees.again_with(table, column)) > 0.1 * static_cast<double>(trees.again())) {
            continue;
        }
        const std::string lower = config::in_lower_case(column);
        const auto is_part = [&](std::string_view word) { return lower.find(word) != std::string::npos; };
        if (std::any_of(stem_words.begin(), stem_words.end(), is_part)) {
            found.are_stems = true;
            continue;
        }
        const bool is_unnamed = std::none_of(census_words.begin(), census_words.end(), is_part);
        if (is_unnamed && !table.has("tree_id")) {
            continue;
        }
        const std::tuple rank{is_unnamed, values.size(), column};
        if (!best || rank < *best) {
            best = rank;
            found.census = column;
            found.censuses = std::move(values);
        }
    }
}

/// Whether the value of a column says that the tree is gone.
bool says_gone(const std::string& column, const std::string& value) {
    if (is_in(gone_columns, column)) {
        return is_in(yes_words, value) || is_in(gone_words, value);
    }
    const bool asks_for_life = column == "alive" || column == "living" || column == "lebend";
    return is_in(status_columns, column) &&
           (is_in(gone_words, value) || (asks_for_life && is_in(no_words, value)));
}

void find_gone(const config::Table& table, RepeatedTrees& found) {
    for (const std::string& column : unread_columns(table)) {
        const std::string lower = config::in_lower_case(column);
        std::size_t gone = 0;
        std::string value;
        for (std::size_t row = 0; row < table.rows(); ++row) {
            if (says_gone(lower, config::in_lower_case(table.seen_text(row, column)))) {
                value = gone++ == 0 ? table.seen_text(row, column) : value;
            }
        }
        if (gone > found.gone) {
            found.gone = gone;
            found.gone_column = column;
            found.gone_value = value;
        }
    }
}

bool is_some(std::size_t count, const config::Table& table) {
    return count >= few && static_cast<double>(count) > some * static_cast<double>(table.rows());
}

void judge_censuses(const RepeatedTrees& found, const config::Table& table, Reading& reading) {
    const std::string last = found.censuses.back();
    std::string values;
    for (std::size_t i = 0; i < found.censuses.size(); ++i) {
        const bool is_left_out = found.censuses.size() > 6 && i >= 3 && i + 1 < found.censuses.size();
        if (!is_left_out) {
            values += joined(i == 0 ? "" : ", ", found.censuses[i]);
        } else if (i == 3) {
            values += ", ...";
        }
    }
    reading.refuse(
        {table.file()},
        joined(std::to_string(found.again), " of ", counted(table.rows(), "tree"),
               " on the spot of another with the same tree_id: column ", config::in_quotes(found.census),
               " distinguishes censuses (", values, ")"),
        "one census: each tree once",
        joined("keep the rows of one of them, such as ", found.census, " = ", last,
               " (filter the table or layer and save the selection), without trees that are gone"));
}

void judge_gone(const RepeatedTrees& found, const config::Table& table, Reading& reading) {
    const std::string what =
        joined(counted(found.gone, "tree"), " with ", config::in_quotes(found.gone_value), " in the column ",
               config::in_quotes(found.gone_column), ", which is not read: they are taken as standing");
    const std::string expected = "the trees that stand";
    const std::string advice =
        "delete the rows of trees that are gone; for dead trees that stand write snag in a column state";
    if (is_some(found.gone, table)) {
        reading.refuse({table.file()}, what, expected, advice);
    } else {
        reading.warn({table.file()}, what, expected, advice);
    }
}

bool has_stems(const config::Table& table) {
    const std::vector<std::string> columns = unread_columns(table);
    return std::any_of(columns.begin(), columns.end(), [](const std::string& column) {
        const std::string lower = config::in_lower_case(column);
        return std::any_of(stem_words.begin(), stem_words.end(),
                           [&](std::string_view word) { return lower.find(word) != std::string::npos; });
    });
}

void warn_of_close_trees(const config::Table& table, Reading& reading) {
    const CloseTrees close = close_trees(table);
    if (are_too_close(close, table.rows())) {
        reading.warn(
            {table.file()},
            joined(std::to_string(std::max(close.inside, close.twins)), " of ", counted(table.rows(), "tree"),
                   " inside the stem of another, or within 0.5 m of one of the same species and dbh_cm"),
            "each tree once, where it stands",
            "keep the rows of one census; measure places to 0.1 m; number the stems of one tree in a column "
            "stem",
            config::Effect::answer);
    }
}

}  // namespace

RepeatedTrees repeated_trees(const config::Table& table) {
    RepeatedTrees found;
    std::vector<const char*> one_tree{"x_m", "y_m"};
    if (table.has("tree_id")) {
        one_tree.push_back("tree_id");
    }
    const Trees trees{table, one_tree};
    found.again = trees.again();
    found.twice =
        Trees{table, {"x_m", "y_m", "species", table.has("dbh_cm") ? "dbh_cm" : "height_m"}}.again();
    if (is_some(found.again, table)) {
        find_census(table, trees, found);
    }
    find_gone(table, found);
    return found;
}

void judge_repeated_trees(const config::Table& table, Reading& reading) {
    const RepeatedTrees found = repeated_trees(table);
    if (found.gone > 0) {
        judge_gone(found, table, reading);
    }
    if (!found.census.empty()) {
        judge_censuses(found, table, reading);
        return;
    }
    const std::string twice = joined(std::to_string(found.twice), " of ", counted(table.rows(), "tree"),
                                     " listed a second time: the same spot, species and dbh_cm");
    if (is_some(found.twice, table)) {
        reading.refuse({table.file()}, twice, "each tree once", "delete the repeated rows");
    } else if (table.has("tree_id") && is_some(found.again, table) && !found.are_stems) {
        reading.refuse({table.file()},
                       joined(std::to_string(found.again), " of ", counted(table.rows(), "tree"),
                              " on the spot of another with the same tree_id"),
                       "each tree once",
                       "delete the repeated rows, such as those of earlier censuses; number the stems of one "
                       "tree in a column stem");
    } else {
        if (found.twice > 0) {
            reading.warn({table.file()}, twice, "each tree once", "delete the repeated rows");
        }
        if (!found.are_stems && !has_stems(table)) {
            warn_of_close_trees(table, reading);
        }
    }
}

}  // namespace coupling::plausible
