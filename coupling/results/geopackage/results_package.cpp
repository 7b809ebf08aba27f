#include "coupling/results/geopackage/results_package.hpp"

#include <algorithm>
#include <memory>
#include <optional>

#include "config/geometry/wkt.hpp"
#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "config/units/constants.hpp"
#include "coupling/inputs/own_files/own_rows.hpp"
#include "coupling/results/figures/figures.hpp"
#include "coupling/results/geopackage/column_types.hpp"
#include "coupling/results/geopackage/plain_number.hpp"

namespace coupling::geopackage {
namespace {

using config::j_per_kj;
using config::joined;

/// Of layers that devices in the field show.
constexpr bool for_the_field = true;

/// A table of the run, read row by row: it may have more rows than memory.
struct TableFile {
    std::filesystem::path place;
    std::optional<TableEnd> end;

    [[nodiscard]] OwnRows rows() const { return OwnRows{place, end}; }
};

/// One table, or several of the same columns that become one.
struct Group {
    std::string layer;
    std::string sentence;
    std::string first;  ///< of its files, as the results name it
    std::vector<TableFile> files;
};

/// The name of a table in the package.
std::string layer_of(const std::string& table) {
    if (table == "stems" || table.starts_with("trees_")) {
        return "trees";
    }
    if (table == "targets") {
        return "target_arrivals";
    }
    return table == "nets"    ? "net_figures"  // the layer `nets` holds the lines
           : table == "works" ? "work_figures"
                              : table;
}

std::vector<Group> groups_of(const Contents& contents) {
    std::vector<Group> groups;
    for (const auto& [file, place] : contents.tables) {
        const std::string table = std::filesystem::path{file.path}.stem().string();
        if (table == "trajectories" || table == "trajectories_wkt") {
            continue;  // the layer `trajectories`: every corner with its energy
        }
        const std::string layer = layer_of(table);
        auto group =
            std::find_if(groups.begin(), groups.end(), [&](const Group& g) { return g.layer == layer; });
        if (group == groups.end()) {
            const bool by_year = table.starts_with("trees_");
            group =
                groups.insert(groups.end(), {layer,
                                             by_year ? "Every tree in the years with a list of trees, and "
                                                       "what it took from the rocks of that year."
                                                     : file.sentence,
                                             file.path,
                                             {}});
        }
        group->files.push_back({place, file.end});
    }
    return groups;
}

/// Where a table keeps the places of its rows.
struct PlaceColumns {
    std::vector<std::size_t> x, y;
    std::optional<std::size_t> z;
    std::optional<std::size_t> wkt{};  ///< polygons as text

    [[nodiscard]] Form form() const {
        return wkt ? Form::mixed : x.empty() ? Form::none : x.size() == 1 ? Form::point : Form::line;
    }
};

PlaceColumns places_in(const std::vector<std::string>& columns, const std::string& x, const std::string& y,
                       const std::string& z) {
    const auto find = [&](const std::string& name) -> std::optional<std::size_t> {
        const auto found = std::find(columns.begin(), columns.end(), name);
        return found == columns.end() ? std::nullopt
                                      : std::optional{static_cast<std::size_t>(found - columns.begin())};
    };
    PlaceColumns places;
    if (find("wkt")) {
        places.wkt = find("wkt");
    } else if (find(x) && find(y)) {
        places = {{*find(x)}, {*find(y)}, find(z)};
    } else if (find("x1_m") && find("y1_m") && find("x2_m") && find("y2_m")) {
        places = {{*find("x1_m"), *find("x2_m")}, {*find("y1_m"), *find("y2_m")}, std::nullopt};
    }
    return places;
}

double number_in(std::string_view field) {
    return plain_number(field).value_or(0.0);
}

Geometry geometry_of(const PlaceColumns& places, const std::vector<std::string_view>& fields,
                     std::int32_t srs_id) {
    if (places.wkt) {
        return polygons(config::read_wkt(fields[*places.wkt], {}).parts, srs_id);
    }
    std::vector<Vertex> vertices;
    for (std::size_t i = 0; i < places.x.size(); ++i) {
        vertices.push_back({number_in(fields[places.x[i]]), number_in(fields[places.y[i]]),
                            places.z ? number_in(fields[*places.z]) : 0.0, 0.0});
    }
    const Dimensions dimensions{.z = places.z.has_value()};
    return vertices.size() == 1 ? point(vertices[0], dimensions, srs_id) : line(vertices, dimensions, srs_id);
}

/// Reports now and then how far a pass through a table is.
class PassWatch {
public:
    PassWatch(const WriteWatch& watch, const std::string& layer)
        : watch_{watch}, what_{joined("results.gpkg, ", layer)} {
        watch_(what_);
    }
    void row(const OwnRows& rows) {
        constexpr std::uint64_t rows_between_reports = 4096;
        if (++rows_ % rows_between_reports == 0) {
            watch_(what_, rows.share());
        }
    }

private:
    const WriteWatch& watch_;
    std::string what_;
    std::uint64_t rows_ = 0;
};

/// All rows of a group. Returns the columns.
std::vector<Column> add_table(GeoPackage& package, const Group& group,
                              const std::vector<TableLayout>& layouts, const WriteWatch& watch) {
    PassWatch pass{watch, group.layer};
    const std::vector<std::string> names = group.files.front().rows().columns();
    std::vector<Column> columns = declared_columns(names, layouts, group.first);
    const PlaceColumns places = places_in(names, "x_m", "y_m", "z_m");
    Layer layer{package, {group.layer, group.sentence, columns, places.form(), {.z = places.z.has_value()}}};
    for (const TableFile& file : group.files) {
        for (OwnRows rows = file.rows(); rows.next();) {
            pass.row(rows);
            if (places.form() == Form::none) {
                layer.add(rows.fields());
            } else {
                const Geometry geometry = geometry_of(places, rows.fields(), package.srs_id());
                layer.add(rows.fields(), &geometry);
            }
        }
    }
    layer.finish();
    return columns;
}

/// Where rocks came to rest, drawn from the table of rocks with its columns.
void add_deposits(GeoPackage& package, const Group& rocks, const std::vector<Column>& columns,
                  const WriteWatch& watch) {
    PassWatch pass{watch, "deposits"};
    const std::vector<std::string> kept{"rock",        "cover",     "zone",          "diameter_m",
                                        "stop_reason", "run_out_m", "max_energy_kj", "tree_hits"};
    OwnRows rows = rocks.files.front().rows();
    std::vector<std::size_t> numbers;
    std::vector<Column> types;
    for (const std::string& name : kept) {
        numbers.push_back(rows.column(name));
        types.push_back(columns[numbers.back()]);
    }
    const auto chosen = [&](std::vector<std::string_view>& fields) {
        fields.clear();
        for (const std::size_t number : numbers) {
            fields.push_back(rows.fields()[number]);
        }
        return fields[4] != coupling::name_of(rockfall::StopReason::left_terrain) &&
               fields[4] != coupling::name_of(rockfall::StopReason::gave_up);
    };
    std::vector<std::string_view> fields;
    const PlaceColumns places = places_in(rows.columns(), "x_end_m", "y_end_m", "z_end_m");
    Layer layer{
        package,
        {"deposits", "Where rocks came to rest, with forest and without.", types, Form::point, {.z = true}}};
    while (rows.next()) {
        pass.row(rows);
        if (chosen(fields)) {
            const Geometry place = geometry_of(places, rows.fields(), package.srs_id());
            layer.add(fields, &place);
        }
    }
    layer.finish();
}

void add_trajectories(GeoPackage& package, const Contents& contents) {
    const std::vector<Column> columns{
        {"rock", ColumnType::whole, "number of the rock"},
        {"cover", ColumnType::text, "forest or bare"},
        {"energy_max_kj", ColumnType::number, "largest energy on the way"},
        {"height_max_m", ColumnType::number, "largest height above the ground on the way"}};
    Layer layer{package,
                {"trajectories",
                 "Sampled paths of rocks in space; the measure of each corner is the energy [kJ].",
                 columns,
                 Form::line,
                 {.z = true, .m = true},
                 {},
                 {},
                 for_the_field}};
    const Eigen::Vector2d origin_m = contents.site.origin_m();
    for (const rockfall::PathRecord& path : contents.paths) {
        if (path.points.size() < 2) {
            continue;  // one point is no line
        }
        std::vector<Vertex> vertices;
        float energy_j = 0.0F;
        float height_m = 0.0F;
        for (const rockfall::PathPoint& p : path.points) {
            vertices.push_back({p.position_m.x() + origin_m.x(), p.position_m.y() + origin_m.y(),
                                p.position_m.z(), static_cast<double>(p.energy_j) / j_per_kj});
            energy_j = std::max(energy_j, p.energy_j);
            height_m = std::max(height_m, p.height_m);
        }
        const Geometry geometry = line(vertices, {.z = true, .m = true}, package.srs_id());
        const std::string rock = std::to_string(path.rock);
        const std::string energy = config::to_text(static_cast<double>(energy_j) / j_per_kj);
        const std::string height = config::to_text(height_m);
        layer.add({rock, coupling::name_of(path.cover), energy, height}, &geometry);
    }
    layer.finish();
}

/// Release cells as squares, pieces of lines and points as what they are.
void add_sources(GeoPackage& package, const Contents& contents) {
    using Kind = rockfall::ReleaseSource::Kind;
    const std::vector<rockfall::ReleaseSource>& sources = contents.site.sources;
    const auto is_point = [](const auto& s) { return s.kind == Kind::line && s.first_m == s.last_m; };
    const auto form_of = [&](const auto& s) {
        return s.kind == Kind::cell ? Form::polygon : is_point(s) ? Form::point : Form::line;
    };
    const Form form = form_of(sources.front());
    const bool same = std::all_of(sources.begin(), sources.end(),
                                  [&](const auto& s) { return form_of(s) == form && s.outline == nullptr; });
    Layer layer{package,
                {"sources",
                 "Where rocks break off: cells, points or pieces of lines.",
                 {{"source", ColumnType::whole, "number of the source"},
                  {"zone", ColumnType::whole, "release zone"},
                  {"rocks", ColumnType::whole, "rocks released on each slope"}},
                 same ? form : Form::mixed,
                 {},
                 {},
                 {},
                 for_the_field}};
    const Eigen::Vector2d origin_m = contents.site.origin_m();
    for (std::size_t number = 0; number < sources.size(); ++number) {
        const rockfall::ReleaseSource& source = sources[number];
        const Eigen::Vector2d first = source.first_m + origin_m;
        const Eigen::Vector2d last = source.last_m + origin_m;
        const std::vector<Vertex> ends{{first.x(), first.y(), 0.0, 0.0}, {last.x(), last.y(), 0.0, 0.0}};
        Geometry geometry;
        if (source.outline) {
            std::vector<std::vector<config::Point2>> rings = source.outline->polygon.parts;
            for (std::vector<config::Point2>& ring : rings) {
                for (config::Point2& corner : ring) {
                    corner = {corner.x_m + origin_m.x(), corner.y_m + origin_m.y()};
                }
            }
            geometry = polygons(rings, package.srs_id());
        } else if (source.kind == Kind::cell) {
            Extent cell;
            cell.add(first.x(), first.y());
            cell.add(last.x(), last.y());
            geometry = rectangle(cell, package.srs_id());
        } else {
            geometry =
                is_point(source) ? point(ends[0], {}, package.srs_id()) : line(ends, {}, package.srs_id());
        }
        const std::string id = std::to_string(number);
        const std::string zone = std::to_string(source.zone);
        const std::string rocks = std::to_string(source.rocks);
        layer.add({id, zone, rocks}, &geometry);
    }
    layer.finish();
}

void add_targets(GeoPackage& package, const Contents& contents) {
    Layer layer{package,
                {"targets",
                 "What is to be protected: lines (roads) and areas (houses).",
                 {{"target_id", ColumnType::text, "id of the target"},
                  {"name", ColumnType::text, "its name"},
                  {"kind", ColumnType::text, "line or area"}},
                 Form::mixed,
                 {},
                 {},
                 {},
                 for_the_field}};
    const Eigen::Vector2d origin_m = contents.site.origin_m();
    for (const rockfall::Target& target : contents.site.targets) {
        std::vector<std::vector<config::Point2>> parts;
        for (const std::vector<Eigen::Vector2d>& part : target.parts) {
            parts.emplace_back();
            for (const Eigen::Vector2d& vertex : part) {
                parts.back().push_back({vertex.x() + origin_m.x(), vertex.y() + origin_m.y()});
            }
        }
        const Geometry geometry =
            target.is_area ? polygons(parts, package.srs_id()) : lines(parts, package.srs_id());
        layer.add({target.id, target.name, target.is_area ? "area" : "line"}, &geometry);
    }
    layer.finish();
}

void add_nets(GeoPackage& package, const Contents& contents) {
    Layer layer{package,
                {"nets",
                 "Rockfall nets and barriers.",
                 {{"net", ColumnType::text, "name of the net"},
                  {"height_m", ColumnType::number, "height of the net"},
                  {"gap_m", ColumnType::number, "gap below it"},
                  {"capacity_kj", ColumnType::number, "energy that it holds"}},
                 Form::line,
                 {},
                 {},
                 {},
                 for_the_field}};
    const Eigen::Vector2d origin_m = contents.site.origin_m();
    for (const NetRecord& record : contents.site.nets) {
        std::vector<Vertex> corners;
        for (const Eigen::Vector2d& corner : record.net.line_m) {
            corners.push_back({corner.x() + origin_m.x(), corner.y() + origin_m.y(), 0.0, 0.0});
        }
        const Geometry geometry = line(corners, {}, package.srs_id());
        const std::string height = config::to_text(record.net.height_m);
        const std::string gap = config::to_text(record.net.gap_m);
        const std::string capacity = config::to_text(record.net.capacity_j / j_per_kj);
        layer.add({record.name, height, gap, capacity}, &geometry);
    }
    layer.finish();
}

void add_works(GeoPackage& package, const Contents& contents) {
    Layer layer{package,
                {"works",
                 "Dams, ditches, walls and galleries.",
                 {{"work", ColumnType::text, "name of the work"},
                  {"kind", ColumnType::text, "dam, ditch, wall or gallery"},
                  {"height_m", ColumnType::number, "height above the ground, or depth"}},
                 Form::mixed,
                 {},
                 {},
                 {},
                 for_the_field}};
    const Eigen::Vector2d origin_m = contents.site.origin_m();
    for (const WorkRecord& work : contents.site.works) {
        const bool is_area = !work.outline_m.empty();
        std::vector<std::vector<config::Point2>> parts(1);
        for (const Eigen::Vector2d& corner : is_area ? work.outline_m : work.line_m) {
            parts.front().push_back({corner.x() + origin_m.x(), corner.y() + origin_m.y()});
        }
        const Geometry geometry =
            is_area ? polygons(parts, package.srs_id()) : lines(parts, package.srs_id());
        const std::string height = work.height_m > 0.0 ? config::to_text(work.height_m) : "";
        layer.add({work.name, name_of(work.kind), height}, &geometry);
    }
    layer.finish();
}

void add_areas(GeoPackage& package, const AreaLayer& areas) {
    Layer layer{package,
                {areas.name, areas.sentence, areas.columns, Form::mixed, {}, areas.drawn_by, areas.classes}};
    for (const AreaLayer::Row& row : areas.rows) {
        const Geometry geometry =
            row.is_line ? lines(row.rings, package.srs_id()) : polygons(row.rings, package.srs_id());
        layer.add({row.fields.begin(), row.fields.end()}, &geometry);
    }
    layer.finish();
}

}  // namespace

std::vector<Written> write_package(const std::filesystem::path& folder, const Contents& contents,
                                   const WriteWatch& watch) {
    const std::vector<Group> groups = groups_of(contents);
    GeoPackage package{folder / "results.gpkg", spatial_reference(contents.site.projection)};
    if (!contents.site.targets.empty()) {
        add_targets(package, contents);
    }
    if (!contents.site.nets.empty()) {
        add_nets(package, contents);
    }
    if (!contents.site.works.empty()) {
        add_works(package, contents);
    }
    if (!contents.site.sources.empty()) {
        add_sources(package, contents);
    }
    if (!contents.paths.empty()) {
        watch("results.gpkg, trajectories");
        add_trajectories(package, contents);
    }
    for (const AreaLayer& areas : contents.areas) {
        add_areas(package, areas);
    }
    for (const Group& group : groups) {
        const std::vector<Column> columns = add_table(package, group, contents.layouts, watch);
        if (group.layer == "rocks") {
            add_deposits(package, group, columns, watch);
        }
    }
    package.close();
    return package.written();
}

}  // namespace coupling::geopackage
