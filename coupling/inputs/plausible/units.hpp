#pragma once

#include "config/table/table.hpp"

namespace coupling::plausible {

/// Throws config::InputError (data) for a list of trees with girths in the place of diameters, by the name of
/// the column.
void refuse_girths_alone(const config::Table& table);

/// Holds a list of trees against what trees look like: throws config::InputError (data) where the medians of
/// `dbh_cm` and `height_m` of the living trees show another unit.
///
/// - A median DBH above 200 is taken for millimetres. So are diameters of which one in twenty is above 150
///   where no height is given or the trees are less than 15 times as high as thick; stands have 60 to 130.
/// - A median below 1.5 is taken for metres where the trees are more than 5 m high or no height is given.
///   Saplings of a centimetre pass with their heights.
/// - A median height above 75 m is taken for decimetres or centimetres: the tallest trees of Europe reach
///   about 70 m. So is a median of more than 300 times the DBH in trees above 5 m.
/// - A median height below 1.3 m of trees of 5 cm or more: DBH is measured at 1.3 m.
///
/// - Ten trees of 5 cm or more of which half are more than 105 times as high as thick, and whose heights vary
///   more than their diameters, have the two columns exchanged. More than 140 times: heights in feet where
///   half of them are above 45 m, else diameters in inches.
///
/// All are choices with a wide margin around real inventories.
void check_tree_units(const config::Table& table);

/// The same for the diameters of lying logs: a median below 1.5 is taken for metres, above 100 for
/// millimetres.
void check_log_units(const config::Table& table);

}  // namespace coupling::plausible
