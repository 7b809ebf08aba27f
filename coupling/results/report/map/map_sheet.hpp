#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "config/geometry/shape.hpp"
#include "config/grid/raster.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/report/map/labels.hpp"
#include "coupling/results/report/map/map_window.hpp"
#include "coupling/results/report/map/scale.hpp"
#include "coupling/results/text/element.hpp"
#include "rockfall/ensemble.hpp"

namespace coupling::report {

/// How wide a map is shown: its lettering is drawn larger on a map that the page makes smaller.
enum class MapSize : std::uint8_t { third, half };

/// One map: what is drawn between hillshade and lines, and how it is explained.
struct MapContent {
    std::string title;
    std::string label;    ///< the whole of what it shows, for those who cannot see it
    std::string drawing;  ///< SVG in the sheet's units
    std::string legend;   ///< SVG
    std::string caption;  ///< HTML
    std::string group{};  ///< what the map shows, for choosing it by script; empty: it cannot be chosen
};

/// The sheet that all maps of a run share: frame, hillshade, contours, stems, sources, targets, scale bar,
/// north.
///
/// Drawings use units of a thousandth of the sheet's width, y down. A grid of more than 700 cells a side is
/// drawn in blocks of cells: a block shows the value of its cells that lies farthest from 0.
class MapSheet {
public:
    /// Refers to the site as long as it lives.
    explicit MapSheet(const Site& site);
    /// Shows a part of the map. Grids are still handed over whole.
    MapSheet(const Site& site, const MapWindow& window);

    /// Names only these targets on the maps, such as those that tables list; without it all that have room.
    void name_only(std::vector<std::size_t> targets) { named_ = std::move(targets); }

    /// Hillshade, the picture of the ground, stems and lines that every map refers to. Once on a page, before
    /// the first map.
    [[nodiscard]] std::string definitions() const;
    /// A grid as a picture in the colours of a scale.
    [[nodiscard]] std::string picture(const config::Raster<float>& raster, const ColourScale& scale) const;
    /// Paths coloured by energy class. Requires at least one point in each.
    [[nodiscard]] std::string paths(std::span<const rockfall::PathRecord* const> chosen) const;
    /// A polygon, rings by the even-odd rule.
    [[nodiscard]] std::string polygon(const config::Shape& shape) const;
    /// Texts at places of the map, centred, where they cover none of the ones before.
    struct PlacedText {
        config::Point2 at;
        std::string text;
    };
    [[nodiscard]] std::string texts(std::span<const PlacedText> placed, MapSize size) const;
    [[nodiscard]] std::string figure(const MapContent& content, MapSize size) const;

    /// How many cells a side a drawn block has: 1 where nothing is left out.
    [[nodiscard]] int block() const { return block_; }
    /// Where a place of the map lies on the sheet, and how large a metre is there: for parts that are drawn
    /// larger (cut_out.hpp).
    [[nodiscard]] DrawnPoint place_on_sheet(const config::Point2& place) const {
        return {x_of(place.x_m), y_of(place.y_m)};
    }
    [[nodiscard]] double units_per_m() const { return units_per_m_; }
    [[nodiscard]] bool has_picture() const { return site_.picture != nullptr; }
    /// One stem in so many is drawn.
    [[nodiscard]] std::size_t stems_a_dot() const;
    [[nodiscard]] double contour_step_m() const { return contour_step_m_; }

private:
    [[nodiscard]] double x_of(double x_m) const { return (x_m - frame_.x_west_m) * units_per_m_; }
    [[nodiscard]] double y_of(double y_m) const { return (frame_.y_north_m() - y_m) * units_per_m_; }
    [[nodiscard]] std::string source_outlines() const;
    [[nodiscard]] std::string source_lines() const;
    [[nodiscard]] std::string target_lines(bool halo) const;
    [[nodiscard]] WrittenNames target_names(double lettering) const;
    [[nodiscard]] std::string distance_marks(double lettering) const;
    [[nodiscard]] std::string contour_lines() const;
    [[nodiscard]] std::string stems() const;
    [[nodiscard]] std::string coordinates(double lettering) const;
    [[nodiscard]] std::string image(const Attribute& name, const std::string& png_bytes) const;
    [[nodiscard]] std::string ground_picture() const;

    const Site& site_;
    MapWindow window_;
    config::GridFrame frame_;  ///< of the window
    int block_;
    double units_per_m_;
    double height_;                     ///< of the sheet in its units
    config::Raster<double> heights_m_;  ///< thinned
    double contour_step_m_;
    std::optional<std::vector<std::size_t>> named_{};
};

}  // namespace coupling::report
