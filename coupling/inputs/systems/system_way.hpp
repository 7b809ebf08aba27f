#pragma once

#include <memory>
#include <optional>
#include <string>

namespace coupling::systems {

/// A place in a coordinate system: easting and northing, or longitude and latitude, whatever order of axes
/// the system has.
struct PlaceInSystem {
    double x = 0.0;
    double y = 0.0;
};

/// Longitude and latitude as devices in the field and Google Earth take them.
inline constexpr const char* wgs84_system = "EPSG:4326";

/// How PROJ goes from one coordinate system to another, which are given by well-known text or by a code such
/// as `wgs84_system`. PROJ chooses the way by the place.
class SystemWay {
public:
    SystemWay(const std::string& from, const std::string& to);
    ~SystemWay();
    SystemWay(SystemWay&&) noexcept;
    SystemWay& operator=(SystemWay&&) noexcept;

    /// False where PROJ does not know one of the systems or no way between them: without a known way between
    /// two datums a shift of up to several hundred metres would be left out in silence.
    [[nodiscard]] bool is_known() const;
    /// Coordinates in the target system; nothing where there are none. Requires a known way.
    [[nodiscard]] std::optional<PlaceInSystem> at(double x, double y);
    /// Whether a shift between datums was left out on the way of a place so far.
    [[nodiscard]] bool is_ballpark() const;
    /// The least accurate way that was used [m]; nothing where PROJ does not know.
    [[nodiscard]] std::optional<double> accuracy_m() const;
    /// "MGI to WGS 84 (18)", as PROJ calls the last one.
    [[nodiscard]] const std::string& name() const;

private:
    struct Handles;
    std::unique_ptr<Handles> handles_;
};

}  // namespace coupling::systems
