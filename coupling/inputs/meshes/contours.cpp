#include "config/errors/input_error.hpp"
#include "config/geometry/wkt.hpp"
#include "config/table/shape_field.hpp"
#include "config/table/table.hpp"
#include "coupling/inputs/formats/mesh_file.hpp"
#include "coupling/inputs/reading/reading.hpp"
#include "coupling/inputs/tables/prepare.hpp"

namespace coupling::meshes {

namespace {

using config::Shape;

constexpr config::NumberRange height_range{.low = -1000.0, .high = 10'000.0};

/// Adds the points of a part and the pieces between them.
void add_part(const std::vector<config::Point2>& part, const std::vector<double>& heights_m, MeshFile& mesh) {
    for (std::size_t i = 0; i < part.size(); ++i) {
        const auto place = static_cast<std::uint32_t>(mesh.points_m.size());
        mesh.points_m.emplace_back(part[i].x_m, part[i].y_m, heights_m[i]);
        if (i > 0) {
            mesh.lines.push_back({place - 1, place});
        }
    }
}

void read_row(const config::Table& table, std::size_t row, MeshFile& mesh, config::Problems& problems) {
    const auto shape = shape_of(table, row, {Shape::Kind::point, Shape::Kind::line}, problems);
    if (!shape) {
        return;
    }
    std::vector<std::vector<double>> heights_m =
        config::read_wkt_heights(table.text(row, "wkt"), table.place(row, "wkt"));
    if (has_value(table, row, "height_m")) {
        const auto height_m = table.number(row, "height_m", height_range, problems);
        for (std::size_t i = 0; i < heights_m.size(); ++i) {
            heights_m[i].assign(shape->parts[i].size(), height_m.value_or(0.0));
        }
    }
    for (std::size_t i = 0; i < heights_m.size(); ++i) {
        if (heights_m[i].empty()) {
            problems.add(config::ExitCode::data, table.place(row, "wkt"), "a point without height",
                         "a third coordinate (LINESTRING Z), or the height of the row in height_m");
            return;
        }
        add_part(shape->parts[i], heights_m[i], mesh);
    }
}

}  // namespace

MeshFile read_contours(std::string_view bytes, const std::string& file) {
    config::Table table = config::Table::read(bytes, file, config::FirstColumn::may_lack_name);
    std::vector<std::string> notes;
    tables::add_remarks(tables::prepare(table, "mesh", false), notes);
    MeshFile mesh = contours_of(table, file);
    tables::add_remarks(tables::findings_of_use(*table.use()), notes);
    mesh.notes = std::move(notes);
    return mesh;
}

MeshFile contours_of(const config::Table& table, const std::string& file) {
    config::Problems problems;
    table.require({"wkt"}, problems);
    problems.throw_if_any();
    MeshFile mesh;
    mesh.format = "points and lines";
    for (std::size_t row = 0; row < table.rows(); ++row) {
        read_row(table, row, mesh, problems);
    }
    config::Problems shown;
    add_first(shown, problems, file);
    shown.throw_if_any();
    return mesh;
}

}  // namespace coupling::meshes
