#include "coupling/assessments/nets/figures/run_terrain.hpp"

#include "config/table/shape_field.hpp"
#include "config/text/joined.hpp"
#include "coupling/inputs/files/file_bytes.hpp"
#include "coupling/inputs/files/files_beside.hpp"
#include "coupling/inputs/files/path_checks.hpp"
#include "coupling/inputs/formats/read_file.hpp"
#include "coupling/inputs/places/line_through.hpp"
#include "coupling/inputs/systems/same_system.hpp"
#include "coupling/inputs/systems/transform_layer.hpp"
#include "coupling/results/geopackage/database.hpp"

namespace coupling {

TableOnRun table_on(const RunTerrain& run, const std::filesystem::path& file, const std::string& expected,
                    std::vector<std::string>& remarks) {
    const formats::LayerName wanted = formats::split_layer_name(file.string());
    const FileBytes bytes = open_file(wanted.file, {file.string()}, expected);
    FilesBeside beside{wanted.file};
    formats::ReadLayer read =
        formats::read_layer_file(bytes.text(), wanted.layer, file.string(), beside.bytes());
    if (plausible::compare_systems(run.projection, read.layer.projection) == plausible::Sameness::other) {
        const systems::Transformed done =
            systems::transform_layer(read.layer, run.projection, "the terrain of the run");
        remarks.push_back(done.note);
        if (!done.warning.empty()) {
            remarks.push_back(config::joined("warning: ", file.string(), ": ", done.warning));
        }
    }
    return {std::move(read.layer.table), read.has_shapes_of_its_own};
}

std::vector<rockfall::Target> houses_of_run(const std::filesystem::path& run,
                                            const rockfall::Terrain& terrain,
                                            std::vector<std::string>& remarks) {
    std::vector<rockfall::Target> targets = houses_and_lines_of_run(run, terrain, remarks);
    std::erase_if(targets, [](const rockfall::Target& target) { return !target.is_area; });
    return targets;
}

std::vector<rockfall::Target> houses_and_lines_of_run(const std::filesystem::path& run,
                                                      const rockfall::Terrain& terrain,
                                                      std::vector<std::string>& remarks) {
    const std::filesystem::path file = run / "results.gpkg";
    if (!path_exists(file)) {
        remarks.push_back(
            "houses of the run are not known, as it has no GeoPackage: nets may run through some");
        return {};
    }
    {
        geopackage::Database database{file.string(), geopackage::Database::Open::to_read};
        geopackage::Statement layer =
            database.prepare("SELECT 1 FROM gpkg_contents WHERE table_name = 'targets'");
        if (!layer.step()) {
            return {};  // a run without targets
        }
    }
    const FileBytes bytes = open_file(file, {file.string()}, "the GeoPackage of a finished run");
    FilesBeside beside{file.string()};
    const formats::ReadLayer read =
        formats::read_layer_file(bytes.text(), "targets", file.string(), beside.bytes());
    const config::Table& table = read.layer.table;
    std::vector<rockfall::Target> targets;
    config::Problems problems;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const auto shape =
            shape_of(table, row, {config::Shape::Kind::line, config::Shape::Kind::polygon}, problems);
        if (!shape) {
            continue;
        }
        rockfall::Target target;
        target.id = table.text(row, "target_id");
        target.is_area = shape->kind == config::Shape::Kind::polygon;
        for (const auto& ring : shape->parts) {
            std::vector<Eigen::Vector2d>& corners = target.parts.emplace_back();
            for (const config::Point2& point : ring) {
                corners.push_back(Eigen::Vector2d{point.x_m, point.y_m} - terrain.origin_m());
            }
        }
        if (!target.is_area || is_house(target)) {
            targets.push_back(rockfall::with_bounds(std::move(target)));
        }
    }
    problems.throw_if_any();
    return targets;
}

}  // namespace coupling
