#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coupling/inputs/parameters/parameter_draws.hpp"
#include "coupling/results/figures/drawn_figure.hpp"
#include "coupling/results/figures/drawn_words.hpp"
#include "coupling/results/templates/page_template.hpp"

namespace coupling::report {

/// Writes a value of a figure.
using Written = std::string (*)(double);

/// "12 to 15 %", "from 12 % on", "at most 15 kJ".
std::string interval_in_words(const Interval& interval, Written written);

/// A bar whose parts are what single parameters bring, darkest first; what is left is joint or small.
std::string cause_bar(const std::vector<NamedShare>& causes);

/// Rows of a table of figures with both intervals, for the template interval_table.html.
class IntervalRows {
public:
    explicit IntervalRows(const ParameterDraws& draws) : draws_{draws} {}

    /// Nothing where the figure has no intervals.
    void add(const std::string& name, const std::optional<DrawnFigure>& figure, Written written);
    /// Ends a group of rows under a name; without rows there is none.
    void end_group(const std::string& name);
    /// All groups.
    [[nodiscard]] PageFields fields() &&;

private:
    const ParameterDraws& draws_;
    std::vector<PageFields> rows_;
    std::vector<PageFields> groups_;
};

}  // namespace coupling::report
