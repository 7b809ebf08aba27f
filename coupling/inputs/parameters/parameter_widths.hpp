#pragma once

#include <string>
#include <vector>

#include "config/table/declared.hpp"
#include "coupling/inputs/reading/reading.hpp"

namespace coupling {

struct ParameterWidthRow;
const config::Schema<ParameterWidthRow>& parameter_width_columns();

/// What is not known of a fall: a factor whose logarithm is normal around 0.
struct ParameterWidth {
    std::string parameter;     ///< as in config/data/parameter_widths.csv
    double width = 0.0;        ///< standard deviation of ln(factor) [-]; 0: taken as known
    std::string source;        ///< of the width, with its mark
    std::string goes_with{};   ///< another parameter; "": independent
    double correlation = 0.0;  ///< with that one, of the logarithms, within (-1, 1)
};

/// The rows of config/data/parameter_widths.csv.
std::vector<ParameterWidth> shipped_parameter_widths();

/// Names that a file may use: those of `widths`, and "losses_on." with each of `grounds`.
std::vector<std::string> parameter_names(const std::vector<ParameterWidth>& widths,
                                         const std::vector<std::string>& grounds);

/// Changes widths to those of a table, and adds those of grounds. `grounds`: names and codes that may follow
/// "losses_on.". Throws InputError (data) with the nearest word for a parameter that there is not, and for
/// correlations that cannot be.
void change_parameter_widths(std::vector<ParameterWidth>& widths, const config::Table& table,
                             const std::vector<std::string>& grounds, Reading& reading);

/// The width of a parameter; 0 where the list has none of that name.
double width_of(const std::vector<ParameterWidth>& widths, const std::string& parameter);

/// The row of a parameter; nullptr where the list has none of that name.
const ParameterWidth* find_width(const std::vector<ParameterWidth>& widths, const std::string& parameter);

}  // namespace coupling
