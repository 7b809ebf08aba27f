#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "coupling/assessments/decades/tables/comparison.hpp"
#include "coupling/results/templates/page_template.hpp"

namespace coupling::decades {

/// A figure with its interval in small letters, for a cell of a table: "12.3 (11.0 – 13.6)". HTML.
std::string interval_cell(const std::string& value, const std::string& low, const std::string& high);
/// A mean, with its interval where it has one; a dash where it is not known. HTML.
std::string band_cell(const Band& band, int decimals);
std::string band_cell(const std::optional<OverReplicates>& value, int decimals);
/// Of a protection effect, percent: a dash too where its interval says nothing (few_rocks.hpp).
std::string protection_cell(const Band& band);
std::string protection_cell(const std::optional<OverReplicates>& value);

/// An amount of three digits, with its interval where it has one. HTML.
std::string amount_cell(const Band& band);
/// A difference, and how many replicates would tell it from 0 where these do not: fields of
/// difference_cell.html.
report::PageFields difference_cell(const std::optional<PairedDifference>& difference, int decimals);
/// The same of amounts of any size: three digits.
report::PageFields difference_cell(const std::optional<PairedDifference>& difference);

/// The first, the middle and the last of some years, each once. Requires at least one.
std::vector<std::int32_t> three_of(const std::vector<std::int32_t>& years);

/// A row of figure_rows.html: a course, and a cell of HTML for each column.
report::PageFields row_of_course(const std::string& title, const std::vector<std::string>& cells);
/// Rows of figure_rows.html under the name of their figure, one for each course, of several years.
report::PageFields figure_over_years(const Names& names, const Series& series, const std::string& name,
                                     const std::vector<std::int32_t>& years, int decimals);
/// Years as heads of columns.
std::vector<report::PageFields> heads_of(const std::vector<std::int32_t>& years);

/// A name that may break after its underscores rather than inside a word. HTML.
std::string breakable(const std::string& name);

}  // namespace coupling::decades
