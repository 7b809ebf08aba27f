#pragma once

#include <optional>
#include <string>
#include <vector>

#include "config/table/schema.hpp"
#include "config/table/table.hpp"
#include "coupling/inputs/works/work_record.hpp"

namespace coupling {

class Reading;

/// What a row of a table of works says.
struct ListedWork {
    std::string name;
    WorkKind kind = WorkKind::dam;
    std::optional<double> height_m;
    std::optional<double> width_m;
    std::optional<double> uphill_face_deg;
    std::optional<double> downhill_face_deg;
    std::optional<double> capacity_kj;
    BarrierCost cost;
    config::Shape shape;
};

const config::Schema<ListedWork>& work_columns();

/// Works as tables give them, in absolute coordinates.
struct GivenWorks {
    struct Named {
        std::size_t table;  ///< in `tables`
        std::size_t row;
    };
    std::vector<WorkRecord> works;
    std::vector<config::Place> places;  ///< where the shape of each stands
    std::vector<Named> rows;
    std::vector<config::Table> tables;  ///< for the column `surface`, whose names need the ground types
};

/// The works of a table, behind those of others. Throws InputError (data) with all that is wrong.
GivenWorks works_of(const config::Table& table, GivenWorks given = {});

/// Reads the works of the scenario; an empty list without them.
std::optional<GivenWorks> read_works(Reading& reading);

}  // namespace coupling
