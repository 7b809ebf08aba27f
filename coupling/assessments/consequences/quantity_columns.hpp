#pragma once

#include "coupling/assessments/consequences/consequence.hpp"

namespace coupling::consequences {

/// A figure a year of tables of risk: `name` is followed by "_per_year".
struct QuantityColumn {
    Quantity quantity;
    const char* name;
    const char* unit;
    const char* meaning;
};

/// Of one place only.
inline constexpr QuantityColumn individual_column{
    Quantity::individual_risk, "individual_risk", "-",
    "chance a year of death of one person who passes (risk.passages_per_day) or is "
    "there (hours_per_day)"};
/// Of places that can be summed.
inline constexpr QuantityColumn counted_columns[]{
    {Quantity::arrivals, "arrivals", "-", "blocks that hit a year"},
    {Quantity::vehicles_hit, "vehicles_hit", "-", "vehicles that are hit a year on a road"},
    {Quantity::deaths, "deaths", "-", "expected deaths a year"},
    {Quantity::damage, "damage", "as the currency says", "expected damage a year to a house"},
    {Quantity::closure_days, "closure_days", "-",
     "expected days of closure of a road a year; empty: not counted"},
    {Quantity::closure, "closure_cost", "as the currency says",
     "what the closure costs a year; empty: not counted"},
    {Quantity::money, "money", "as the currency says",
     "deaths at risk.prevented_death, damage and closure together, a year"}};

/// Six digits: the rest is noise. Small rates need more decimals than a column can promise.
double six_digits(double value);

}  // namespace coupling::consequences
