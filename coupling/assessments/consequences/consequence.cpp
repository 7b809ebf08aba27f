#include "coupling/assessments/consequences/consequence.hpp"

#include <algorithm>

#include "coupling/assessments/consequences/presence.hpp"

namespace coupling::consequences {
namespace {

void add_road(const TargetExposure& road, const CurveClass& energy, double block_diameter_m,
              const RiskSettings& settings, Quantities& of) {
    const double length_m = road.vehicle_length_m.value_or(settings.vehicle_length_m);
    const auto in_the_way = [&](double vehicles_per_day) {
        return vehicles_in_the_way(vehicles_per_day, length_m, block_diameter_m, road.speed_kmph.value());
    };
    const double vehicles = in_the_way(road.vehicles_per_day.value());
    of[index_of(Quantity::vehicles_hit)] = vehicles;
    of[index_of(Quantity::deaths)] =
        vehicles * road.persons_per_vehicle.value() * energy.lethality_in_vehicle;
    of[index_of(Quantity::individual_risk)] =
        in_the_way(settings.passages_per_day) * energy.lethality_in_vehicle;
    of[index_of(Quantity::closure_days)] = settings.closure_days;
    of[index_of(Quantity::closure)] = settings.closure_days * settings.closure_cost_per_day;
}

void add_house(const TargetExposure& house, const CurveClass& energy, Quantities& of) {
    const double of_one = share_of_day(house.hours_per_day.value_or(0.0)) * energy.lethality_in_house;
    of[index_of(Quantity::individual_risk)] = of_one;
    of[index_of(Quantity::deaths)] = house.persons.value_or(0.0) * of_one;
    of[index_of(Quantity::damage)] = house.house_value.value_or(0.0) * energy.damage_to_house;
}

}  // namespace

Quantities consequence(const TargetExposure& exposure, const CurveClass& energy, double block_diameter_m,
                       const RiskSettings& settings) {
    Quantities of{};
    of[index_of(Quantity::arrivals)] = 1.0;
    if (exposure.is_road()) {
        add_road(exposure, energy, block_diameter_m, settings, of);
    }
    if (exposure.is_house()) {
        add_house(exposure, energy, of);
    }
    of[index_of(Quantity::money)] = of[index_of(Quantity::deaths)] * settings.prevented_death +
                                    of[index_of(Quantity::damage)] + of[index_of(Quantity::closure)];
    return of;
}

bool has_what_counts(const TargetExposure& exposure, Quantity quantity, const RiskSettings& settings) {
    switch (quantity) {
        case Quantity::individual_risk:
        case Quantity::deaths:
            return exposure.is_road() || exposure.persons.has_value();
        case Quantity::damage:
            return exposure.house_value.has_value();
        case Quantity::vehicles_hit:
            return exposure.is_road();
        case Quantity::closure_days:
        case Quantity::closure:
            return exposure.is_road() && settings.closure_days > 0.0;
        case Quantity::arrivals:
        case Quantity::money:
            break;
    }
    return true;
}

bool any_has_what_counts(std::span<const TargetExposure> exposures, Quantity quantity,
                         const RiskSettings& settings) {
    return std::any_of(exposures.begin(), exposures.end(), [&](const TargetExposure& exposure) {
        return has_what_counts(exposure, quantity, settings);
    });
}

}  // namespace coupling::consequences
