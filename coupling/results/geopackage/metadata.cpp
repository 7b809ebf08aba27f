#include "coupling/results/geopackage/metadata.hpp"

#include "config/text/joined.hpp"

namespace coupling::geopackage {
namespace {

using config::joined;

/// The standard asks for the time of the last change. Results know no time, so that the same run gives the
/// same bytes; the beginning of Unix time says that it is none.
constexpr const char* no_time = "1970-01-01T00:00:00.000Z";

constexpr const char* wgs84 =
    "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS "
    "84\",6378137,298.257223563,AUTHORITY[\"EPSG\",\"7030\"]],"
    "AUTHORITY[\"EPSG\",\"6326\"]],PRIMEM[\"Greenwich\",0,AUTHORITY[\"EPSG\",\"8901\"]],UNIT[\"degree\","
    "0.0174532925199433,AUTHORITY[\"EPSG\",\"9122\"]],AUTHORITY[\"EPSG\",\"4326\"]]";

constexpr const char* tables =
    "CREATE TABLE gpkg_spatial_ref_sys (srs_name TEXT NOT NULL, srs_id INTEGER NOT NULL PRIMARY KEY, "
    "organization TEXT NOT NULL, organization_coordsys_id INTEGER NOT NULL, definition TEXT NOT NULL, "
    "description TEXT);"
    "CREATE TABLE gpkg_contents (table_name TEXT NOT NULL PRIMARY KEY, data_type TEXT NOT NULL, identifier "
    "TEXT UNIQUE, "
    "description TEXT DEFAULT '', last_change DATETIME NOT NULL DEFAULT "
    "(strftime('%Y-%m-%dT%H:%M:%fZ','now')), "
    "min_x DOUBLE, min_y DOUBLE, max_x DOUBLE, max_y DOUBLE, srs_id INTEGER, "
    "CONSTRAINT fk_gc_r_srs_id FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys(srs_id));"
    "CREATE TABLE gpkg_geometry_columns (table_name TEXT NOT NULL, column_name TEXT NOT NULL, "
    "geometry_type_name TEXT NOT NULL, srs_id INTEGER NOT NULL, z TINYINT NOT NULL, m TINYINT NOT NULL, "
    "CONSTRAINT pk_geom_cols PRIMARY KEY (table_name, column_name), CONSTRAINT uk_gc_table_name UNIQUE "
    "(table_name), "
    "CONSTRAINT fk_gc_tn FOREIGN KEY (table_name) REFERENCES gpkg_contents(table_name), "
    "CONSTRAINT fk_gc_srs FOREIGN KEY (srs_id) REFERENCES gpkg_spatial_ref_sys (srs_id));"
    "CREATE TABLE gpkg_extensions (table_name TEXT, column_name TEXT, extension_name TEXT NOT NULL, "
    "definition TEXT NOT NULL, scope TEXT NOT NULL, "
    "CONSTRAINT ge_tce UNIQUE (table_name, column_name, extension_name));";

void add_reference(Database& database, const SpatialReference& reference) {
    Statement insert = database.prepare("INSERT INTO gpkg_spatial_ref_sys VALUES (?, ?, ?, ?, ?, NULL)");
    insert.bind(1, reference.name)
        .bind(2, static_cast<std::int64_t>(reference.id))
        .bind(3, reference.organization);
    insert.bind(4, static_cast<std::int64_t>(reference.organization_id)).bind(5, reference.definition);
    insert.run();
}

/// The triggers of the R-tree extension (F.3 of the standard): when a row comes, goes, or changes its place
/// or number. They call functions that GIS programs have and plain SQLite has not: without those a row cannot
/// be edited, only read.
std::string triggers(const std::string& layer) {
    const std::string table = sql_name(layer);
    const std::string index = index_name(layer);
    const std::string put =
        joined("INSERT OR REPLACE INTO ", index,
               " VALUES (NEW.fid, ST_MinX(NEW.geom), ST_MaxX(NEW.geom), ST_MinY(NEW.geom), "
               "ST_MaxY(NEW.geom));");
    const auto drop = [&](const char* row) {
        return joined("DELETE FROM ", index, " WHERE id = ", row, ".fid;");
    };
    const auto trigger = [&](const char* name, const char* event, const char* condition,
                             const std::string& action) {
        return joined("CREATE TRIGGER ", sql_name(joined("rtree_", layer, "_geom_", name)), " AFTER ", event,
                      " ON ", table, condition, " BEGIN ", action, " END;");
    };
    const char* const filled = "(NEW.geom NOTNULL AND NOT ST_IsEmpty(NEW.geom))";
    const char* const empty = "(NEW.geom ISNULL OR ST_IsEmpty(NEW.geom))";
    const auto when = [](const char* rows, const char* place) { return joined(" WHEN ", rows, place); };
    const char* const same_row = "OLD.fid = NEW.fid AND ";
    const char* const other_row = "OLD.fid != NEW.fid AND ";
    std::string sql = trigger("insert", "INSERT", when("", filled).c_str(), put);
    sql += trigger("update1", "UPDATE OF geom", when(same_row, filled).c_str(), put);
    sql += trigger("update2", "UPDATE OF geom", when(same_row, empty).c_str(), drop("OLD"));
    sql += trigger("update3", "UPDATE", when(other_row, filled).c_str(), drop("OLD") + put);
    sql += trigger("update4", "UPDATE", when(other_row, empty).c_str(),
                   joined("DELETE FROM ", index, " WHERE id IN (OLD.fid, NEW.fid);"));
    sql += trigger("delete", "DELETE", " WHEN OLD.geom NOT NULL", drop("OLD"));
    return sql;
}

void add_contents(Database& database, const Written& layer, const SpatialReference& reference) {
    const bool has_places = layer.plan.form != Form::none;
    Statement insert = database.prepare("INSERT INTO gpkg_contents VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
    insert.bind(1, layer.plan.name).bind(2, has_places ? "features" : "attributes").bind(3, layer.plan.name);
    insert.bind(4, layer.plan.sentence).bind(5, no_time);
    if (!layer.extent.empty) {
        insert.bind(6, layer.extent.low_x_m).bind(7, layer.extent.low_y_m);
        insert.bind(8, layer.extent.high_x_m).bind(9, layer.extent.high_y_m);
    }
    if (has_places) {
        insert.bind(10, static_cast<std::int64_t>(reference.id));
    }
    insert.run();
}

void add_geometry_column(Database& database, const Written& layer, const SpatialReference& reference) {
    Statement insert = database.prepare("INSERT INTO gpkg_geometry_columns VALUES (?, 'geom', ?, ?, ?, ?)");
    insert.bind(1, layer.plan.name).bind(2, name_of(layer.plan.form));
    insert.bind(3, static_cast<std::int64_t>(reference.id));
    insert.bind(4, std::int64_t{layer.plan.dimensions.z}).bind(5, std::int64_t{layer.plan.dimensions.m});
    insert.run();
    Statement extension = database.prepare(
        "INSERT INTO gpkg_extensions VALUES (?, 'geom', 'gpkg_rtree_index', "
        "'http://www.geopackage.org/spec130/#extension_rtree', 'write-only')");
    extension.bind(1, layer.plan.name);
    extension.run();
}

/// The table of the schema extension, and the entries that make it known: once for a file.
constexpr const char* column_descriptions =
    "CREATE TABLE IF NOT EXISTS gpkg_data_columns (table_name TEXT NOT NULL, column_name TEXT NOT NULL, name "
    "TEXT, title TEXT, description TEXT, mime_type TEXT, constraint_name TEXT, "
    "CONSTRAINT pk_gdc PRIMARY KEY (table_name, column_name), "
    "CONSTRAINT gdc_tn UNIQUE (table_name, name));"
    "CREATE TABLE IF NOT EXISTS gpkg_data_column_constraints (constraint_name TEXT NOT NULL, constraint_type "
    "TEXT NOT NULL, value TEXT, min NUMERIC, min_is_inclusive BOOLEAN, max NUMERIC, max_is_inclusive "
    "BOOLEAN, description TEXT, CONSTRAINT gdcc_ntv UNIQUE (constraint_name, constraint_type, value));"
    "INSERT OR IGNORE INTO gpkg_extensions SELECT name, NULL, 'gpkg_schema', "
    "'http://www.geopackage.org/spec130/#extension_schema', 'read-write' FROM sqlite_master WHERE name IN "
    "('gpkg_data_columns', 'gpkg_data_column_constraints') AND NOT EXISTS (SELECT 1 FROM gpkg_extensions "
    "WHERE extension_name = 'gpkg_schema');";

void describe_columns(Database& database, const Plan& plan) {
    database.execute(column_descriptions);
    Statement insert =
        database.prepare("INSERT INTO gpkg_data_columns VALUES (?, ?, NULL, ?, ?, NULL, NULL)");
    for (const Column& column : plan.columns) {
        const std::string title =
            column.unit.empty() ? column.name : joined(column.name, " [", column.unit, "]");
        insert.bind(1, plan.name).bind(2, column.name).bind(3, title).bind(4, column.meaning);
        insert.run();
    }
}

}  // namespace

void create_metadata(Database& database, const SpatialReference& reference) {
    database.execute("PRAGMA application_id = 0x47504B47; PRAGMA user_version = 10300;");
    database.execute(tables);
    add_reference(database, SpatialReference{});
    add_reference(database, {0, "Undefined geographic SRS", "NONE", 0, "undefined"});
    if (reference.id != 4326) {
        add_reference(database, {4326, "WGS 84 geodetic", "EPSG", 4326, wgs84});
    }
    if (reference.id != -1) {
        add_reference(database, reference);
    }
}

const char* name_of(Form form) {
    switch (form) {
        case Form::point:
            return "POINT";
        case Form::line:
            return "LINESTRING";
        case Form::multi_line:
            return "MULTILINESTRING";
        case Form::polygon:
            return "POLYGON";
        case Form::multi_polygon:
            return "MULTIPOLYGON";
        case Form::mixed:
        case Form::none:
            break;
    }
    return "GEOMETRY";
}

std::string index_table(const std::string& layer) {
    return joined("rtree_", layer, "_geom");
}

std::string index_name(const std::string& layer) {
    return sql_name(index_table(layer));
}

std::string create_index(const std::string& layer) {
    return joined("CREATE VIRTUAL TABLE ", index_name(layer), " USING rtree(id, minx, maxx, miny, maxy)");
}

void register_layer(Database& database, const Written& layer, const SpatialReference& reference) {
    add_contents(database, layer, reference);
    if (layer.plan.form != Form::none) {
        add_geometry_column(database, layer, reference);
        database.execute(triggers(layer.plan.name));  // last: the rows of this run need none
    }
    if (layer.plan.describes_columns) {
        describe_columns(database, layer.plan);
    }
}

}  // namespace coupling::geopackage
