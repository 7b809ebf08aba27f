#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "config/options/options.hpp"
#include "validation/engine/case/case_files.hpp"
#include "validation/engine/case/comparison.hpp"

namespace coupling::validation {

/// What case.ini of a case over years says beside [case].
struct YearsSettings {
    std::string scenario = "scenario.ini";  ///< a scenario of `bannwald run` in the folder of the case
    std::string figures = "figures.sql";    ///< figures, tables and charts of the page (queries.hpp)
    bool standard = true;                   ///< with the standard figures, tables and charts
    std::string forget;                     ///< result tables that go once a site has its figures
    std::uint64_t from_year = 1;            ///< figures look at this year of the run and those after it
    std::uint64_t seeds = 1;                ///< figures are means over so many seeds, with their deviation
    std::uint64_t states_every = 1;         ///< years between the states of single species that figures see
};

/// Declares [years].
void declare(config::Options& options, YearsSettings& settings);

/// A scenario over years, simulated at each site of sites.csv as `bannwald run` does it, and figures that
/// queries over its result tables give.
///
/// The columns of sites.csv are `site`, `words` (its name for people) and settings of the scenario
/// (section.name); `overrides` come after them. Throws InputError with what is wrong at the first such
/// site, or with the first query that is.
Comparison read_years(const CaseFiles& files, const YearsSettings& settings,
                      const std::vector<std::string>& overrides);

}  // namespace coupling::validation
