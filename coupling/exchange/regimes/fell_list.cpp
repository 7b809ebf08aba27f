#include "coupling/exchange/regimes/fell_list.hpp"

#include <algorithm>
#include <tuple>

#include "config/table/schema.hpp"
#include "config/text/joined.hpp"

namespace coupling {

struct FelledTreeRow {
    std::uint64_t tree_id = 0;
    int year = 0;
};

namespace {

using config::joined;

bool is_calendar_year(const ListedTree& tree) {
    return tree.year >= least_calendar_year;
}

/// Year 0 is the start in both ways of counting.
bool is_run_year(const ListedTree& tree) {
    return tree.year > 0 && tree.year < least_calendar_year;
}

}  // namespace

const config::Schema<FelledTreeRow>& felled_tree_columns() {
    // clang-format off
    static const config::Schema<FelledTreeRow> columns{
        {.role = "felled_trees", .setting = "regime column trees", .row = "tree", .no_rows = "a row for each felled tree"},
        {{"tree_id", &FelledTreeRow::tree_id, "as in the list of trees; each once: it can be felled in one year", {.range = {0.0, 1e12}, .unique = true, .advice = "leave one of the rows out"}},
         {"year", &FelledTreeRow::year, "of the run, from 0, or calendar year", {.range = {0.0, 10'000.0}}}}};
    // clang-format on
    return columns;
}

std::vector<ListedTree> read_fell_list(const config::Table& table) {
    config::RowProblems wrong{table};
    std::vector<ListedTree> list;
    for (const config::Read<FelledTreeRow>& row : felled_tree_columns().rows(table, wrong)) {
        list.push_back({row.tree_id, row.year});
    }
    if (std::any_of(list.begin(), list.end(), is_calendar_year) &&
        std::any_of(list.begin(), list.end(), is_run_year)) {
        wrong.refuse("calendar years beside years of the run",
                     "one way of counting: calendar years, or years since the start of the run");
    }
    wrong.throw_first();
    std::sort(list.begin(), list.end(), [](const ListedTree& a, const ListedTree& b) {
        return std::tie(a.year, a.tree) < std::tie(b.year, b.tree);
    });
    return list;
}

void use_run_years(std::vector<ListedTree>& list, const std::string& file, const RunYears& run,
                   config::Problems& problems) {
    bool any_in_run = false;
    for (ListedTree& tree : list) {
        if (is_calendar_year(tree)) {
            const int of_run = tree.year - run.start_calendar_year;
            if (run.start_calendar_year <= 0 || of_run < 0) {
                problems.add(config::ExitCode::data, {file},
                             joined("tree_id ", std::to_string(tree.tree), " felled in ",
                                    std::to_string(tree.year), ", before the run"),
                             run.start_calendar_year > 0
                                 ? joined("a year from ", std::to_string(run.start_calendar_year), " on")
                                 : "a year of the run, counted from 0",
                             "begin the run earlier (run.first_year), or leave the tree out of the list of "
                             "trees and of this one");
                return;
            }
            tree.year = of_run;
        }
        any_in_run = any_in_run || tree.year <= run.last;
    }
    if (!any_in_run) {
        problems.add(
            config::ExitCode::data, {file},
            joined("no tree of it is felled in the run, which ends with year ", std::to_string(run.last)),
            "at least one year of the run", "let the run be longer (run.years)");
    }
}

}  // namespace coupling
