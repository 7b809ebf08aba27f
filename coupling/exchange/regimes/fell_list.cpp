#include "coupling/exchange/regimes/fell_list.hpp"

#include <algorithm>
#include <map>
#include <tuple>

#include "config/text/joined.hpp"

namespace coupling {
namespace {

using config::joined;

constexpr double highest_tree_id = 1e12;  // as in the list of trees
constexpr double latest_year = 10'000.0;

bool is_calendar_year(const ListedTree& tree) {
    return tree.year >= least_calendar_year;
}

/// Year 0 is the start in both ways of counting.
bool is_run_year(const ListedTree& tree) {
    return tree.year > 0 && tree.year < least_calendar_year;
}

}  // namespace

std::vector<ListedTree> read_fell_list(const config::Table& table) {
    config::Problems problems;
    table.require({"tree_id", "year"}, problems);
    problems.throw_if_any();
    std::vector<ListedTree> list;
    std::map<std::uint64_t, std::size_t> rows;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto id = table.whole(row, "tree_id", {0.0, highest_tree_id}, problems);
        const auto year = table.whole(row, "year", {0.0, latest_year}, problems);
        if (!id || !year) {
            continue;
        }
        const auto number = static_cast<std::uint64_t>(*id);
        if (const auto [first, is_new] = rows.emplace(number, row); !is_new) {
            problems.add(config::ExitCode::data, table.place(row, "tree_id"),
                         joined("tree_id ", table.text(row, "tree_id"), " a second time, as in line ",
                                std::to_string(table.place(first->second, "tree_id").line)),
                         "each tree once: it can be felled in one year", "leave one of the rows out");
        }
        list.push_back({number, static_cast<int>(*year)});
    }
    if (table.rows() == 0) {
        problems.add(config::ExitCode::data, {table.file()}, "no tree", "a row for each felled tree");
    }
    if (std::any_of(list.begin(), list.end(), is_calendar_year) &&
        std::any_of(list.begin(), list.end(), is_run_year)) {
        problems.add(config::ExitCode::data, {table.file()}, "calendar years beside years of the run",
                     "one way of counting: calendar years, or years since the start of the run");
    }
    problems.throw_if_any();
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
