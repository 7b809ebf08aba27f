#pragma once

#include <ostream>
#include <span>

#include "coupling/results/figures/colours.hpp"
#include "coupling/results/maps/rasters.hpp"

namespace coupling {

/// A QGIS layer style (.qml), which QGIS finds beside the raster and takes on opening it.
void write_style(std::ostream& out, const RasterKind& kind, ValueRange range);
/// Each class up to the value that stands for it, above that of the one before.
void write_class_style(std::ostream& out, std::span<const ClassColour> classes);
/// The style of a difference: blue (less with forest) over white to red, the same reach either way.
void write_difference_style(std::ostream& out, const RasterKind& kind, ValueRange range);

}  // namespace coupling
