#include "coupling/assessments/nets/figures/net_layers.hpp"

#include <functional>
#include <utility>

#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/own_files/own_rows.hpp"
#include "coupling/results/geopackage/column_types.hpp"

namespace coupling {
namespace {

using geopackage::Geometry;

/// Adds a table as a layer, each row with the geometry that `place` gives for its number.
void add_layer(geopackage::GeoPackage& package, geopackage::Plan plan, const TableLayout& layout,
               const std::string& csv, const std::function<Geometry(std::size_t)>& place) {
    OwnRows rows{csv, plan.name};
    plan.columns = geopackage::declared_columns(rows.columns(), {layout}, layout.file);
    geopackage::Layer layer{package, std::move(plan)};
    for (std::size_t number = 0; rows.next(); ++number) {
        const Geometry geometry = place(number);
        layer.add(rows.fields(), &geometry);
    }
    layer.finish();
}

}  // namespace

std::string projection_of_run(const std::filesystem::path& run) {
    const std::filesystem::path file = run / "rasters" / "bare" / "Nr_passages.prj";
    return path_exists(file) ? std::string{open_file(file, {file.string()}, "a projection file").text()} : "";
}

void add_lines(geopackage::GeoPackage& package, const std::string& name, const std::string& sentence,
               const TableWithLines& table, const Eigen::Vector2d& origin_m) {
    add_layer(package, {name, sentence, {}, geopackage::Form::line, {}}, table.layout, table.csv,
              [&](std::size_t number) {
                  std::vector<geopackage::Vertex> corners;
                  for (const Eigen::Vector2d& corner : table.lines[number]) {
                      corners.push_back({corner.x() + origin_m.x(), corner.y() + origin_m.y(), 0.0, 0.0});
                  }
                  return geopackage::line(corners, {}, package.srs_id());
              });
}

void add_points(geopackage::GeoPackage& package, const std::string& name, const std::string& sentence,
                const TableLayout& layout, const std::string& csv,
                std::span<const Eigen::Vector2d> places_m) {
    add_layer(package, {name, sentence, {}, geopackage::Form::point, {}}, layout, csv,
              [&](std::size_t number) {
                  return geopackage::point({places_m[number].x(), places_m[number].y(), 0.0, 0.0}, {},
                                           package.srs_id());
              });
}

}  // namespace coupling
