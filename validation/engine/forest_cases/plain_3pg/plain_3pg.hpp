#pragma once

#include <vector>

#include "validation/engine/forest_cases/plain_3pg/stand.hpp"

namespace coupling::validation::forest_cases::plain_3pg {

/// Grows a plain 3-PG stand: no individual trees, one mean tree a species, as r3PG 0.1.7 does (Trotsiuk,
/// Hartig & Forrester 2020). It exists to hold the production core against other programs' published runs.
///
/// One row a species and month, the first of them the starting state. Not modelled: the correction for size
/// distributions, carbon isotopes.
///
/// Requires parameters for each species in the same order, see `inputs_of`.
std::vector<Row> run(const Inputs& inputs, const Settings& settings);

/// Puts the tables of a run together. Throws InputError (data) for species that have no parameters.
Inputs inputs_of(const Site& site, std::vector<StartingSpecies> species,
                 const std::vector<Parameters>& parameters, std::vector<ClimateMonth> climate,
                 std::vector<Thinning> thinnings);

}  // namespace coupling::validation::forest_cases::plain_3pg
