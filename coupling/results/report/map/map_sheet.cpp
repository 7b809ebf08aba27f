#include "coupling/results/report/map/map_sheet.hpp"

#include <algorithm>
#include <cmath>

#include "config/text/joined.hpp"
#include "coupling/inputs/picture/ground_picture.hpp"
#include "coupling/results/report/map/blocks.hpp"
#include "coupling/results/report/map/contours.hpp"
#include "coupling/results/report/map/distance_marks.hpp"
#include "coupling/results/report/map/hillshade.hpp"
#include "coupling/results/report/map/jpeg.hpp"
#include "coupling/results/report/map/labels.hpp"
#include "coupling/results/report/map/map_furniture.hpp"
#include "coupling/results/report/map/outlines.hpp"
#include "coupling/results/report/map/png.hpp"
#include "coupling/results/templates/page_template.hpp"
#include "coupling/results/text/element.hpp"
#include "coupling/results/text/join_texts.hpp"
#include "coupling/results/text/markup.hpp"
#include "coupling/results/text/page_text.hpp"

namespace coupling::report {
namespace {

using config::joined;

constexpr double sheet_width = 1000.0;
constexpr int most_cells_a_side = 700;

int block_for(const config::GridFrame& frame) {
    return (std::max(frame.columns, frame.rows) + most_cells_a_side - 1) / most_cells_a_side;
}

/// Type size in units of the sheet, so that about 11 px are seen.
double lettering_of(MapSize size) {
    return size == MapSize::third ? 31.0 : 20.0;
}

/// One height from the middle of each block: enough to shade it.
config::Raster<double> thinned(const config::Raster<double>& heights_m, int block) {
    config::GridFrame frame = heights_m.frame;
    frame.columns = (frame.columns + block - 1) / block;
    frame.rows = (frame.rows + block - 1) / block;
    frame.cell_width_m *= block;
    frame.cell_height_m *= block;
    config::Raster<double> thin{frame};
    for (std::size_t i = 0; i < thin.values.size(); ++i) {
        const config::Cell cell = frame.cell_of(i);
        thin.values[i] = heights_m.at({std::min(cell.column * block + block / 2, heights_m.frame.columns - 1),
                                       std::min(cell.row * block + block / 2, heights_m.frame.rows - 1)});
    }
    return thin;
}

std::string of_names_left_out(std::size_t targets) {
    return targets == 0 ? ""
                        : page_text("{unnamed} targets have no name on this map: no room.",
                                    {{"unnamed", std::to_string(targets)}});
}

}  // namespace

MapSheet::MapSheet(const Site& site) : MapSheet{site, whole_of(site.map_frame)} {}

MapSheet::MapSheet(const Site& site, const MapWindow& window)
    : site_{site},
      window_{window},
      frame_{part_of(site.map_frame, window)},
      block_{block_for(frame_)},
      units_per_m_{sheet_width / (frame_.x_east_m() - frame_.x_west_m)},
      height_{(frame_.y_north_m() - frame_.y_south_m) * units_per_m_},
      heights_m_{thinned(site.heights.frame.columns == site.map_frame.columns &&
                                 site.heights.frame.rows == site.map_frame.rows
                             ? part_of(site.heights, window)
                             : site.heights,
                         block_)},
      contour_step_m_{report::contour_step_m(heights_m_)} {}

std::string MapSheet::image(const Attribute& name, const std::string& png_bytes) const {
    // Blocks at the eastern and southern rim reach over it.
    const double columns = static_cast<double>((frame_.columns + block_ - 1) / block_ * block_);
    const double rows = static_cast<double>((frame_.rows + block_ - 1) / block_ * block_);
    return element("image", {name,
                             {"width", sheet_width * columns / frame_.columns},
                             {"height", height_ * rows / frame_.rows},
                             {"preserveAspectRatio", "none"},
                             {"href", data_address(png_bytes)}});
}

/// The aerial picture or map at its place, which may be larger or smaller than the sheet; empty without one.
std::string MapSheet::ground_picture() const {
    if (!site_.picture) {
        return {};
    }
    constexpr std::size_t most_bytes = 750'000;  // a megabyte in base64
    const config::GridFrame& frame = site_.picture->frame;
    return element("image", {{"id", "ground-picture"},
                             {"x", x_of(frame.x_west_m)},
                             {"y", y_of(frame.y_north_m())},
                             {"width", (frame.x_east_m() - frame.x_west_m) * units_per_m_},
                             {"height", (frame.y_north_m() - frame.y_south_m) * units_per_m_},
                             {"preserveAspectRatio", "none"},
                             {"href", jpeg_address(jpeg_of_at_most(site_.picture->pixels, most_bytes))}});
}

std::string MapSheet::definitions() const {
    const std::string shade = png(hillshade(illumination(heights_m_)));
    const std::string sheet = element("rect", {{"width", sheet_width}, {"height", height_}});
    return joined(
        svg_definitions(joined(
            image({"id", "shade"}, shade), ground_picture(), element("clipPath", {{"id", "sheet"}}, sheet),
            element("path", {{"id", "contours"}, {"class", "contour"}, {"d", contour_lines()}}), stems(),
            element("g", {{"id", "sources"}}, joined(source_outlines(), source_lines())),
            element("g", {{"id", "targets"}}, joined(target_lines(true), target_lines(false))))),
        "\n");
}

std::string MapSheet::picture(const config::Raster<float>& raster, const ColourScale& scale) const {
    const bool whole = window_ == whole_of(raster.frame);
    const config::Raster<float> shown = in_blocks(whole ? raster : part_of(raster, window_), block_);
    IndexedPicture drawn{shown.frame.columns, shown.frame.rows,
                         std::vector<std::uint8_t>(shown.values.size()), scale.palette()};
    std::transform(shown.values.begin(), shown.values.end(), drawn.pixels.begin(),
                   [&](float value) { return scale.index_of(value); });
    return image({"class", "values"}, png(drawn));
}

std::string MapSheet::paths(std::span<const rockfall::PathRecord* const> chosen) const {
    // Whole units of the sheet are finer than a pixel: smaller steps are drawn with the next one that is
    // large enough.
    constexpr double least_step = 2.0;
    std::array<PathText, energy_class_colours.size()> by_class;
    const Eigen::Vector2d origin_m = site_.origin_m();
    const auto on_sheet = [&](const rockfall::PathPoint& point) {
        return DrawnPoint{std::round(x_of(point.position_m.x() + origin_m.x())),
                          std::round(y_of(point.position_m.y() + origin_m.y()))};
    };
    for (const rockfall::PathRecord* const path : chosen) {
        float energy_j = 0.0F;
        DrawnPoint last = on_sheet(path->points.front());
        for (const rockfall::PathPoint& point : path->points) {
            energy_j = std::max(energy_j, point.energy_j);
            const DrawnPoint next = on_sheet(point);
            if (std::hypot(next.x - last.x, next.y - last.y) >= least_step ||
                &point == &path->points.back()) {
                by_class[energy_class(static_cast<double>(energy_j) / 1000.0)].line(last.x, last.y, next.x,
                                                                                    next.y);
                energy_j = point.energy_j;
                last = next;
            }
        }
    }
    std::string svg;
    for (std::size_t k = 0; k < by_class.size(); ++k) {
        svg += svg_path(joined("class", std::to_string(k)), by_class[k].text());
    }
    return element("g", {{"class", "paths"}}, svg);
}

std::string MapSheet::contour_lines() const {
    // A line every few pixels is fine enough: of large maps every second or third height.
    constexpr int most_heights_a_side = 200;
    const int step = (std::max(heights_m_.frame.columns, heights_m_.frame.rows) + most_heights_a_side - 1) /
                     most_heights_a_side;
    return contours(step > 1 ? thinned(heights_m_, step) : heights_m_, contour_step_m_,
                    [&](double x_m, double y_m) {
                        return DrawnPoint{x_of(x_m), y_of(y_m)};
                    });
}

std::size_t MapSheet::stems_a_dot() const {
    constexpr std::size_t most_dots = 12'000;
    return site_.trees.size() / most_dots + 1;
}

/// Dots in three sizes by diameter; a dot is a line without length under a round pen.
std::string MapSheet::stems() const {
    constexpr std::array<double, 2> limits_cm{20.0, 40.0};
    std::array<std::string, limits_cm.size() + 1> dots;
    for (std::size_t i = 0; i < site_.trees.size(); i += stems_a_dot()) {
        const rockfall::Stem& stem = site_.trees[i].stem;
        const double x = x_of(stem.x_m);
        const double y = y_of(stem.y_m);
        if (x >= 0.0 && x <= sheet_width && y >= 0.0 && y <= height_) {
            const std::size_t size = stem.dbh_cm < limits_cm[0] ? 0 : stem.dbh_cm < limits_cm[1] ? 1 : 2;
            dots[size] += joined("M", place(std::round(x)), " ", place(std::round(y)), "h0");
        }
    }
    std::string svg;
    for (std::size_t size = 0; size < dots.size(); ++size) {
        svg += svg_path(joined("stems", std::to_string(size)), dots[size]);
    }
    return element("g", {{"id", "stems"}}, svg);
}

std::string MapSheet::polygon(const config::Shape& shape) const {
    std::string path;
    for (const std::vector<config::Point2>& ring : shape.parts) {
        const char* step = "M";
        for (const config::Point2& corner : ring) {
            path += joined(step, place(x_of(corner.x_m)), " ", place(y_of(corner.y_m)));
            step = "L";
        }
        path += "Z";
    }
    return element("path", {{"fill-rule", "evenodd"}, {"clip-path", "url(#sheet)"}, {"d", path}});
}

std::string MapSheet::source_outlines() const {
    // A grid that marks whose cell centres lie in a source cell; smaller sources mark the cell they lie in.
    config::Raster<std::uint8_t> inside{frame_, 0};
    const Eigen::Vector2d origin_m = site_.origin_m();
    for (const rockfall::ReleaseSource& source : site_.sources) {
        if (source.kind != rockfall::ReleaseSource::Kind::cell) {
            continue;
        }
        const Eigen::Vector2d low = source.first_m + origin_m;
        const Eigen::Vector2d high = source.last_m + origin_m;
        const config::Cell from =
            frame_.cell_at(low.x() + 0.5 * frame_.cell_width_m, high.y() - 0.5 * frame_.cell_height_m);
        const config::Cell to =
            frame_.cell_at(high.x() - 0.5 * frame_.cell_width_m, low.y() + 0.5 * frame_.cell_height_m);
        for (int row = from.row; row <= std::max(from.row, to.row); ++row) {
            for (int column = from.column; column <= std::max(from.column, to.column); ++column) {
                if (frame_.contains({column, row})) {
                    inside.at({column, row}) = 1;
                }
            }
        }
    }
    return svg_path("source", outlines(inside, sheet_width / frame_.columns, height_ / frame_.rows));
}

std::string MapSheet::source_lines() const {
    std::string svg;
    const Eigen::Vector2d origin_m = site_.origin_m();
    for (const rockfall::ReleaseSource& source : site_.sources) {
        if (source.kind != rockfall::ReleaseSource::Kind::line) {
            continue;
        }
        const Eigen::Vector2d a = source.first_m + origin_m;
        const Eigen::Vector2d b = source.last_m + origin_m;
        if (source.first_m == source.last_m) {
            svg += element("circle",
                           {{"class", "source"}, {"r", 5.0}, {"cx", x_of(a.x())}, {"cy", y_of(a.y())}});
        } else {
            PathText line;
            line.line(x_of(a.x()), y_of(a.y()), x_of(b.x()), y_of(b.y()));
            svg += svg_path("source", line.text());
        }
    }
    return svg;
}

std::string MapSheet::target_lines(bool halo) const {
    std::string svg;
    const Eigen::Vector2d origin_m = site_.origin_m();
    for (const rockfall::Target& target : site_.targets) {
        PathText text;
        for (const auto& part : target.parts) {
            for (std::size_t i = 0; i + 1 < part.size(); ++i) {
                const Eigen::Vector2d a = part[i] + origin_m;
                const Eigen::Vector2d b = part[i + 1] + origin_m;
                text.line(x_of(a.x()), y_of(a.y()), x_of(b.x()), y_of(b.y()));
            }
        }
        svg += svg_path(joined(halo ? "halo" : "target", target.is_area ? " area" : ""), text.text());
    }
    const auto draw = [&](const char* kind, const std::vector<Eigen::Vector2d>& line) {
        PathText text;
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const Eigen::Vector2d a = line[i] + origin_m;
            const Eigen::Vector2d b = line[i + 1] + origin_m;
            text.line(x_of(a.x()), y_of(a.y()), x_of(b.x()), y_of(b.y()));
        }
        svg += svg_path(halo ? "halo" : kind, text.text());
    };
    for (const NetRecord& record : site_.nets) {
        draw("net", record.net.line_m);
    }
    for (const WorkRecord& work : site_.works) {
        draw("work", work.outline_m.empty() ? work.line_m : work.outline_m);
    }
    return svg;
}

WrittenNames MapSheet::target_names(double lettering) const {
    std::vector<NamedShape> shapes;
    const Eigen::Vector2d origin_m = site_.origin_m();
    for (std::size_t i = 0; i < site_.targets.size(); ++i) {
        const rockfall::Target& target = site_.targets[i];
        if (named_ && std::find(named_->begin(), named_->end(), i) == named_->end()) {
            continue;
        }
        NamedShape shape{target.name.empty() ? target.id : target.name, {}};
        for (const auto& part : target.parts) {
            shape.parts.emplace_back();
            for (const Eigen::Vector2d& vertex : part) {
                shape.parts.back().push_back(
                    {x_of(vertex.x() + origin_m.x()), y_of(vertex.y() + origin_m.y())});
            }
        }
        if (!shape.parts.empty() && !shape.parts.front().empty()) {
            shapes.push_back(std::move(shape));
        }
    }
    const SheetSize sheet{sheet_width, height_, units_per_m_, lettering};
    const std::vector<DistanceMark> marks = distance_marks_of(site_, sheet, [&](const Eigen::Vector2d& at_m) {
        return DrawnPoint{x_of(at_m.x()), y_of(at_m.y())};
    });
    std::vector<LetteredBox> taken = covered_by(marks, lettering);
    const std::vector<LetteredBox> furniture = furniture_boxes(sheet);
    taken.insert(taken.end(), furniture.begin(), furniture.end());
    return write_names(shapes, std::move(taken), lettering, sheet_width, height_);
}

std::string MapSheet::texts(std::span<const PlacedText> placed, MapSize size) const {
    const double lettering = mark_lettering * lettering_of(size);
    std::vector<LetteredBox> taken;
    std::string svg;
    for (const PlacedText& one : placed) {
        const double width = box_of(one.text, 0.0, 0.0, lettering).east;
        const double x = x_of(one.at.x_m);
        const double y = y_of(one.at.y_m) + 0.35 * lettering;
        const LetteredBox box = box_of(one.text, x - 0.5 * width, y, lettering);
        const bool is_free = std::none_of(taken.begin(), taken.end(), [&](const LetteredBox& other) {
            return box.west < other.east && other.west < box.east && box.north < other.south &&
                   other.north < box.south;
        });
        if (is_free && box.west >= 0.0 && box.east <= sheet_width && box.north >= 0.0 &&
            box.south <= height_) {
            taken.push_back(box);
            svg += svg_text(x, y, one.text,
                            {{"class", "name"}, {"text-anchor", "middle"}, {"font-size", lettering}});
        }
    }
    return svg;
}

std::string MapSheet::distance_marks(double lettering) const {
    std::string svg;
    const SheetSize sheet{sheet_width, height_, units_per_m_, lettering};
    for (const DistanceMark& mark : distance_marks_of(site_, sheet, [&](const Eigen::Vector2d& at_m) {
             return DrawnPoint{x_of(at_m.x()), y_of(at_m.y())};
         })) {
        svg += element("circle", {{"class", "mark"}, {"cx", mark.at.x}, {"cy", mark.at.y}, {"r", 5.0}});
        svg += svg_text(mark.text_x(), mark.text_y(), mark.text,
                        {{"class", "distance"}, {"font-size", mark_lettering * lettering}});
    }
    return svg;
}

std::string MapSheet::coordinates(double lettering) const {
    const double step_m = nice_step(170.0 / units_per_m_);
    std::string marks, svg;
    for (double x_m = std::ceil(frame_.x_west_m / step_m) * step_m; x_m < frame_.x_east_m(); x_m += step_m) {
        const double x = x_of(x_m);
        marks += joined("M", place(x), " ", place(height_), "v8M", place(x), " 0v-8");
        svg += svg_text(x, height_ + 8.0 + 0.8 * lettering, fixed(x_m, 0), {{"text-anchor", "middle"}});
    }
    for (double y_m = std::ceil(frame_.y_south_m / step_m) * step_m; y_m < frame_.y_north_m();
         y_m += step_m) {
        const double y = y_of(y_m);
        marks += joined("M0 ", place(y), "h-8M", place(sheet_width), " ", place(y), "h8");
        const std::string text = fixed(y_m, 0);
        const double half_width = 0.5 * box_of(text, 0.0, 0.0, 0.8 * lettering).east;
        if (y + half_width > height_ + 6.0) {
            continue;  // it would run into the numbers below the map
        }
        svg += element(
            "text",
            {{"text-anchor", "middle"}, {"transform", joined("translate(-12 ", place(y), ")rotate(-90)")}},
            text);
    }
    return element("g", {{"class", "coordinates"}, {"font-size", 0.8 * lettering}},
                   joined(svg, element("path", {{"d", marks}})));
}

std::string MapSheet::figure(const MapContent& content, MapSize size) const {
    const double lettering = lettering_of(size);
    const bool large = size == MapSize::half;
    const double margin = large ? 34.0 : 4.0;
    const std::string box = joined(place(-margin), " ", place(large ? -12.0 : -4.0), " ",
                                   place(sheet_width + margin + (large ? 12.0 : 4.0)), " ",
                                   place(height_ + margin + (large ? 12.0 : 4.0)));
    const SheetSize sheet{sheet_width, height_, units_per_m_, lettering};
    const WrittenNames names = large ? target_names(lettering) : WrittenNames{};
    const std::string caption = join_sentences({content.caption, of_names_left_out(names.left_out)});
    return filled_template("map_figure.html",
                           {{"title", content.title},
                            {"can_be_chosen", !content.group.empty()},
                            {"group", content.group},
                            {"legend", content.legend},
                            {"box", box},
                            {"width", place(sheet_width)},
                            {"height", place(height_)},
                            {"drawing", content.drawing},
                            {"has_picture", site_.picture != nullptr},
                            {"coordinates", large ? coordinates(lettering) : ""},
                            {"is_large", large},
                            {"names", large ? joined(distance_marks(lettering), names.svg) : ""},
                            {"furniture", joined(scale_bar(sheet), north_arrow(sheet))},
                            {"has_caption", !caption.empty()},
                            {"caption", caption}});
}

}  // namespace coupling::report
