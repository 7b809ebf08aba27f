#include "coupling/results/geopackage/package.hpp"

#include <cassert>
#include <charconv>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/results/geopackage/metadata.hpp"

namespace coupling::geopackage {
namespace {

using config::joined;

const char* sql_type(ColumnType type) {
    switch (type) {
        case ColumnType::whole:
            return "INTEGER";
        case ColumnType::number:
            return "REAL";
        case ColumnType::text:
            break;
    }
    return "TEXT";
}

std::string create_statement(const Plan& plan) {
    std::string sql =
        joined("CREATE TABLE ", sql_name(plan.name), " (fid INTEGER PRIMARY KEY AUTOINCREMENT NOT NULL");
    if (plan.form != Form::none) {
        sql += joined(", geom ", name_of(plan.form));
    }
    for (const Column& column : plan.columns) {
        sql += joined(", ", sql_name(column.name), " ", sql_type(column.type));
    }
    return sql += ")";
}

std::string insert_statement(const Plan& plan) {
    std::string sql = joined("INSERT INTO ", sql_name(plan.name), " VALUES (NULL");
    const std::size_t values = plan.columns.size() + (plan.form == Form::none ? 0 : 1);
    for (std::size_t i = 0; i < values; ++i) {
        sql += ", ?";
    }
    return sql += ")";
}

}  // namespace

GeoPackage::GeoPackage(const std::filesystem::path& file, SpatialReference reference)
    : reference_{std::move(reference)}, database_{file, Database::Open::empty} {
    database_.execute("BEGIN");
    create_metadata(database_, reference_);
}

void GeoPackage::close() {
    database_.execute("COMMIT");
    database_.close();
}

Layer::Layer(GeoPackage& package, Plan plan) : package_{package}, written_{std::move(plan), 0, {}} {
    const Plan& p = written_.plan;
    package_.database_.execute(create_statement(p));
    insert_.emplace(package_.database_, insert_statement(p));
    if (p.form != Form::none) {
        package_.database_.execute(create_index(p.name));
        insert_extent_.emplace(package_.database_,
                               joined("INSERT INTO ", index_name(p.name), " VALUES (?, ?, ?, ?, ?)"));
    }
}

void Layer::bind(int parameter, ColumnType type, std::string_view field) {
    const char* const end = field.data() + field.size();
    std::int64_t whole = 0;
    double number = 0.0;
    if (field.empty()) {
        insert_->bind_null(parameter);
    } else if (type == ColumnType::whole && std::from_chars(field.data(), end, whole).ptr == end) {
        insert_->bind(parameter, whole);
    } else if (type == ColumnType::number && std::from_chars(field.data(), end, number).ptr == end) {
        insert_->bind(parameter, number);
    } else {
        insert_->bind(parameter, field);
    }
}

void Layer::add(const std::vector<std::string_view>& fields, const Geometry* geometry) {
    assert(fields.size() == written_.plan.columns.size());
    assert((geometry == nullptr) == (written_.plan.form == Form::none));
    int parameter = 1;
    if (geometry != nullptr) {
        insert_->bind_bytes(parameter++, geometry->bytes);
    }
    for (std::size_t i = 0; i < fields.size(); ++i) {
        bind(parameter++, written_.plan.columns[i].type, fields[i]);
    }
    insert_->run();
    ++written_.rows;
    if (geometry != nullptr) {
        const Extent& extent = geometry->extent;
        insert_extent_->bind(1, static_cast<std::int64_t>(written_.rows));
        insert_extent_->bind(2, extent.low_x_m).bind(3, extent.high_x_m);
        insert_extent_->bind(4, extent.low_y_m).bind(5, extent.high_y_m);
        insert_extent_->run();
        written_.extent.add(extent);
    }
}

void Layer::finish() {
    insert_.reset();
    insert_extent_.reset();
    register_layer(package_.database_, written_, package_.reference_);
    package_.written_.push_back(std::move(written_));
}

}  // namespace coupling::geopackage
