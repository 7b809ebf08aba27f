#pragma once

#include <optional>
#include <string>
#include <vector>

#include "config/geometry/shape.hpp"
#include "coupling/inputs/reading/reading.hpp"

namespace coupling {

/// Who and what is at a target, as the columns of targets.file say: a road has `vehicles_per_day`, a house
/// `persons` or `house_value`.
struct TargetExposure {
    std::optional<double> vehicles_per_day{};     ///< >= 0, both directions
    std::optional<double> speed_kmph{};           ///< > 0
    std::optional<double> persons_per_vehicle{};  ///< >= 0
    std::optional<double> vehicle_length_m{};     ///< > 0; none: risk.vehicle_length_m
    std::optional<double> persons{};              ///< >= 0, who live or work there
    std::optional<double> hours_per_day{};        ///< [0, 24], that each of them is there
    std::optional<double> house_value{};          ///< >= 0, in risk.currency

    [[nodiscard]] bool is_road() const { return vehicles_per_day.has_value(); }
    [[nodiscard]] bool is_house() const { return persons.has_value() || house_value.has_value(); }
};

/// A row of targets.file.
struct TargetRow : TargetExposure {
    std::string id;
    std::string name;
    config::Shape shape;
};

/// A target that is exposed.
struct ExposedTarget {
    std::string id;
    TargetExposure exposure;
};

/// The targets of targets.file with a road's or a house's columns, in the order of the files. Refuses (data)
/// what does not go together: speed without vehicles, persons without hours, a road that is a house, more
/// vehicles than fit on the road one behind the other; and a file that exposes none.
std::vector<ExposedTarget> read_exposed_targets(Reading& reading, double vehicle_length_m);

}  // namespace coupling
