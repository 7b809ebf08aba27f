#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "config/table/declared.hpp"
#include "config/table/table.hpp"

namespace coupling::consequences {

/// What a block of a class of energy does where it hits; shares [0, 1].
struct CurveClass {
    double energy_from_kj = 0.0;        ///< up to the next class
    double lethality_in_vehicle = 0.0;  ///< of a person in the vehicle
    double lethality_in_house = 0.0;    ///< of a person somewhere in the house
    double damage_to_house = 0.0;       ///< of its value
};
const config::Schema<CurveClass>& curve_columns();

/// Lethality and damage by energy, as steps.
class Curves {
public:
    /// Throws config::InputError (data) for a table without a class from 0 kJ, with a class twice or with a
    /// share that falls as the energy rises.
    static Curves read(const config::Table& table);
    /// Of config/data/risk_curves.csv.
    static Curves shipped();

    [[nodiscard]] const std::vector<CurveClass>& classes() const { return classes_; }
    /// Number of the class of an energy, from 0.
    [[nodiscard]] std::size_t class_of(double energy_kj) const;

private:
    std::vector<CurveClass> classes_;  ///< rising
};

}  // namespace coupling::consequences
