#include "coupling/results/geopackage/package.hpp"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <utility>

#include "config/text/joined.hpp"
#include "coupling/results/geopackage/metadata.hpp"
#include "coupling/results/geopackage/plain_number.hpp"

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

/// Each statement has a cost of its own, so many rows share one.
constexpr std::size_t rows_a_statement = 16;

std::string insert_statement(const Plan& plan, std::size_t rows) {
    std::string row = "(NULL";
    const std::size_t values = plan.columns.size() + (plan.form == Form::none ? 0 : 1);
    for (std::size_t i = 0; i < values; ++i) {
        row += ", ?";
    }
    row += ")";
    std::string sql = joined("INSERT INTO ", sql_name(plan.name), " VALUES ");
    for (std::size_t i = 0; i < rows; ++i) {
        sql += joined(i == 0 ? "" : ", ", row);
    }
    return sql;
}

/// Digits behind the point; 0 for a number with an exponent.
std::size_t decimals_of(std::string_view number) {
    std::size_t behind_point = number.size();
    for (std::size_t i = 0; i < number.size(); ++i) {
        if (number[i] == 'e' || number[i] == 'E') {
            return 0;
        }
        if (number[i] == '.' && behind_point == number.size()) {
            behind_point = i + 1;
        }
    }
    return number.size() - behind_point;
}

}  // namespace

GeoPackage::GeoPackage(const std::filesystem::path& file, SpatialReference reference)
    : reference_{std::move(reference)}, database_{file, Database::Open::empty} {
    begin();
}

GeoPackage::GeoPackage(SpatialReference reference, const std::string& name)
    : reference_{std::move(reference)}, database_{name, Database::Open::in_memory} {
    begin();
}

void GeoPackage::begin() {
    database_.execute("BEGIN");
    create_metadata(database_, reference_);
}

void GeoPackage::close() {
    database_.execute("COMMIT");
    database_.close();
}

std::string GeoPackage::bytes() {
    database_.execute("COMMIT");
    return database_.bytes();
}

Layer::Layer(GeoPackage& package, Plan plan)
    : package_{package}, written_{std::move(plan), 0, {}}, waiting_(rows_a_statement) {
    const Plan& p = written_.plan;
    written_.decimals.resize(p.columns.size());
    package_.database_.execute(create_statement(p));
    insert_many_.emplace(package_.database_, insert_statement(p, rows_a_statement));
}

void Layer::Value::take(ColumnType type, std::string_view field) {
    kind = Kind::null;
    if (field.empty()) {
        return;
    }
    if (type == ColumnType::whole) {
        const char* const end = field.data() + field.size();
        const auto [last, error] = std::from_chars(field.data(), end, whole);
        kind = last == end && error == std::errc{} ? Kind::whole : Kind::text;
    } else if (type == ColumnType::number) {
        const std::optional<double> found = plain_number(field);
        number = found.value_or(0.0);
        kind = found ? Kind::number : Kind::text;
    } else {
        kind = Kind::text;
    }
    if (kind == Kind::text) {
        text.assign(field);
    }
}

void Layer::bind(Statement& insert, int parameter, const Value& value) {
    switch (value.kind) {
        case Value::Kind::null:
            insert.bind_null(parameter);
            break;
        case Value::Kind::whole:
            insert.bind(parameter, value.whole);
            break;
        case Value::Kind::number:
            insert.bind(parameter, value.number);
            break;
        case Value::Kind::text:
            insert.bind(parameter, value.text);
            break;
    }
}

void Layer::insert_rows(Statement& insert, std::size_t first, std::size_t count) {
    int parameter = 1;
    for (std::size_t row = first; row < first + count; ++row) {
        if (written_.plan.form != Form::none) {
            insert.bind_bytes(parameter++, waiting_[row].geometry);
        }
        for (const Value& value : waiting_[row].values) {
            bind(insert, parameter++, value);
        }
    }
    insert.run();
}

void Layer::add(const std::vector<std::string_view>& fields, const Geometry* geometry) {
    assert(fields.size() == written_.plan.columns.size());
    assert((geometry == nullptr) == (written_.plan.form == Form::none));
    Waiting& row = waiting_[waiting_rows_++];
    row.values.resize(fields.size());
    for (std::size_t i = 0; i < fields.size(); ++i) {
        row.values[i].take(written_.plan.columns[i].type, fields[i]);
        if (written_.plan.columns[i].type == ColumnType::number) {
            written_.decimals[i] = std::max(written_.decimals[i], decimals_of(fields[i]));
        }
    }
    ++written_.rows;
    if (geometry != nullptr) {
        row.geometry = geometry->bytes;
        index_.add(geometry->extent);
        written_.extent.add(geometry->extent);
    }
    if (waiting_rows_ == rows_a_statement) {
        insert_rows(*insert_many_, 0, rows_a_statement);
        waiting_rows_ = 0;
    }
}

void Layer::finish() {
    insert_many_.reset();
    const Plan& plan = written_.plan;
    {
        Statement insert_one{package_.database_, insert_statement(plan, 1)};
        for (std::size_t row = 0; row < waiting_rows_; ++row) {
            insert_rows(insert_one, row, 1);
        }
    }
    if (plan.form != Form::none) {
        package_.database_.execute(create_index(plan.name));
        index_.write(package_.database_, index_table(plan.name));
    }
    register_layer(package_.database_, written_, package_.reference_);
    package_.written_.push_back(std::move(written_));
}

}  // namespace coupling::geopackage
