#pragma once

#include <string>
#include <vector>

#include "config/errors/input_error.hpp"
#include "config/table/table.hpp"

namespace coupling::climate {

/// Climate as services deliver it becomes the monthly table that the forest reads: days become months, dates
/// become year and month, numbers in other units ours. Requires the names of formats/column_names.hpp. Each
/// change is a note.
///
/// A month is made of its days unless more than five of them, or more than three in a row, lack a value
/// (WMO 1989, Calculation of monthly and annual 30-year standard normals, WMO-TD 341); the sum of its
/// precipitation is the mean of known days times its days. Of days the longest run of whole years is taken;
/// years that are left out are named, at the ends in a note, else in a warning. A table of months in our
/// columns and units stays as it is.
struct Delivered {
    std::vector<std::string> notes;
    std::vector<config::Problem> warnings;
};

/// Throws InputError for dates that are none, rows of several places or hours, months in columns, units
/// without a way to ours, and days without one whole year.
Delivered take_delivered(config::Table& table);

}  // namespace coupling::climate
