#pragma once

#include <string>
#include <vector>

#include "config/table/schema.hpp"
#include "coupling/inputs/places/target_exposure.hpp"
#include "coupling/inputs/reading/reading.hpp"

namespace coupling {

/// Whether a name of a column has this word, but for one wrong letter or two exchanged ones: "value",
/// "Building value", "house_vaule". With risk.assess the reader of targets warns, as of the answer, of a
/// column that nobody reads and that is called like one that is missing.
bool has_word_like(const std::string& column, const std::string& wanted);

/// Warns of what makes a risk too small or too large without a wrong field: lines without traffic beside
/// houses with persons, columns that nobody reads beside missing ones, values in thousands, speeds in m/s,
/// more persons than a house holds. For scenarios with risk.assess; `rows` are those of the table.
void judge_exposure(const config::Table& table, const std::vector<config::Read<TargetRow>>& rows,
                    Reading& reading);

/// A house with persons or a value.
struct ExposedHouse {
    std::string id;
    config::Shape outline;
    config::Place place;
};

/// Warns of houses of all lists that lie partly over each other, and so are hit and counted twice.
void judge_doubled_houses(const std::vector<ExposedHouse>& houses, Reading& reading);

/// Warns of exposed targets, by their ids, that lie close beyond the terrain: rocks may reach them, and their
/// risk is not counted.
void judge_exposed_beyond(const std::vector<std::string>& ids, const config::Place& place, Reading& reading);

}  // namespace coupling
