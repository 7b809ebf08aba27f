#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "coupling/results/figures/colours.hpp"
#include "coupling/results/maps/rasters.hpp"

namespace coupling::report {

/// An entry of a legend: a drawing of about 26 x 14 units above its baseline, and its name.
struct LegendEntry {
    std::string sample;
    std::string name;
};

/// The legend of classes in rows of `a_row`, or of fewer where a name is too long for that, as an SVG
/// drawing.
std::string class_legend_of(std::size_t count, std::size_t a_row, const std::string& style,
                            const std::function<LegendEntry(std::size_t)>& entry_of);

/// How the values of a map become colours, and their legend.
class ColourScale {
public:
    /// The classes of energy of colours.hpp.
    static ColourScale energy_classes();
    /// Values that stand for classes; no other value is drawn.
    static ColourScale classes(std::vector<ClassColour> classes);
    /// Straight from 0 to a round number not below `high`.
    static ColourScale linear(Palette palette, double high, std::string unit);
    /// By powers of ten from `low` (values below it take its colour) to a round number not below `high`.
    static ColourScale logarithmic(Palette palette, double low, double high, std::string unit);
    /// Both ways from 0 to round numbers not below `reach`; blue below, red above.
    static ColourScale difference(double reach, std::string unit);

    /// Index into palette(): 0 (see-through) for NaN.
    [[nodiscard]] std::uint8_t index_of(float value) const;
    [[nodiscard]] std::vector<Colour> palette() const;
    /// An SVG drawing, `id` unique on the page: it names the colour ramp.
    [[nodiscard]] std::string legend(const std::string& id) const;

private:
    enum class Kind : std::uint8_t { energy, classes, linear, logarithmic, difference };
    ColourScale(Kind kind, Palette palette, double low, double high, std::string unit);
    [[nodiscard]] double place_of(double value) const;
    [[nodiscard]] std::vector<double> ticks() const;

    Kind kind_;
    Palette palette_;
    double low_;
    double high_;
    std::string unit_;
    std::vector<ClassColour> classes_{};  ///< of a scale of classes
};

}  // namespace coupling::report
