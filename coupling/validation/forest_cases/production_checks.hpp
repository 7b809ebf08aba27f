#pragma once

#include "config/errors/warnings.hpp"
#include "config/table/table.hpp"
#include "coupling/validation/forest_cases/plain_3pg/plain_3pg.hpp"

namespace coupling::validation::forest_cases {

/// The tables that a 3-PG run was read from.
struct ProductionTables {
    config::Table site;
    config::Table start;
    config::Table climate;
};

/// Adds warnings for columns of these tables that nothing reads, for less rain than any forest has, and for
/// a run in which no species is planted in its first month.
void warn_of_inputs(const ProductionTables& tables, const plain_3pg::Inputs& inputs,
                    config::Warnings& warnings);

/// Throws InputError (data) where the seasons of the climate contradict the latitude of the site.
void check_latitude(const ProductionTables& tables, const plain_3pg::Inputs& inputs);

}  // namespace coupling::validation::forest_cases
