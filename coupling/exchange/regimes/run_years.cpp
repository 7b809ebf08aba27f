#include "coupling/exchange/regimes/run_years.hpp"

#include <optional>
#include <string>

#include "config/text/joined.hpp"

namespace coupling {
namespace {

using config::joined;

bool is_calendar(int year) {
    return year >= least_calendar_year;
}

/// Year 0 is the start in both ways of counting.
bool is_of_run(int year) {
    return year > 0 && !is_calendar(year);
}

class YearChecker {
public:
    YearChecker(const RunYears& run, config::Problems& problems) : run_{run}, problems_{problems} {}

    /// Whether a row says calendar years and another (or the same) years of the run.
    void refuse_both_kinds(std::span<const Intervention> rows) {
        const Intervention* calendar = nullptr;
        const Intervention* of_run = nullptr;
        for (const Intervention& row : rows) {
            const int last = row.last_year.value_or(0);
            calendar = is_calendar(row.first_year) || is_calendar(last) ? &row : calendar;
            of_run = is_of_run(row.first_year) || is_of_run(last) ? &row : of_run;
        }
        if (calendar != nullptr && of_run != nullptr) {
            problems_.add(
                config::ExitCode::data, of_run->place,
                joined("years of the run in ", of_run->name, ", calendar years in ", calendar->name),
                "one way of counting in first_year and last_year of all rows: calendar years, or "
                "years since the start of the run");
        }
    }

    void translate(Intervention& row) {
        const bool first_is_calendar = is_calendar(row.first_year);
        if (const auto year = year_of_run(row, "first_year", row.first_year)) {
            row.first_year = *year;
        }
        if (row.last_year && is_calendar(*row.last_year)) {
            // Years after the run end with it.
            row.last_year = *row.last_year - run_.start_calendar_year;
            if (run_.start_calendar_year > 0 && *row.last_year < 0) {
                refuse_calendar(row, "last_year", *row.last_year + run_.start_calendar_year);
            }
        }
        if (!first_is_calendar && row.after.empty() && row.first_year > run_.last) {
            problems_.add(config::ExitCode::data, row.place,
                          joined("first_year = ", std::to_string(row.first_year), ": ", row.name,
                                 " could never act, the run ends with year ", std::to_string(run_.last)),
                          joined("a year of the run from 0 to ", std::to_string(run_.last),
                                 ", a calendar year, or a longer run (run.years)"));
        }
    }

private:
    std::optional<int> year_of_run(const Intervention& row, const char* column, int year) {
        if (!is_calendar(year)) {
            return std::nullopt;
        }
        const int of_run = year - run_.start_calendar_year;
        if (run_.start_calendar_year <= 0 || of_run < 0 || of_run > run_.last) {
            refuse_calendar(row, column, year);
            return std::nullopt;
        }
        return of_run;
    }

    void refuse_calendar(const Intervention& row, const char* column, int year) {
        problems_.add(config::ExitCode::data, row.place,
                      joined(column, " = ", std::to_string(year), ": ", row.name, " could never act"),
                      run_.start_calendar_year > 0
                          ? joined("a calendar year from ", std::to_string(run_.start_calendar_year), " to ",
                                   std::to_string(run_.start_calendar_year + run_.last),
                                   ", which the run simulates, or a year of the run from 0 to ",
                                   std::to_string(run_.last))
                          : "a year of the run, counted from 0");
    }

    const RunYears& run_;
    config::Problems& problems_;
};

}  // namespace

void use_run_years(std::vector<Intervention>& rows, const RunYears& run, config::Problems& problems) {
    YearChecker checker{run, problems};
    checker.refuse_both_kinds(rows);
    for (Intervention& row : rows) {
        checker.translate(row);
    }
}

}  // namespace coupling
