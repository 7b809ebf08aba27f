#include "coupling/results/geopackage/stored_rows.hpp"

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"

namespace coupling::geopackage {
namespace {

std::string select_statement(const Plan& plan) {
    std::string sql = "SELECT geom";
    for (const Column& column : plan.columns) {
        sql += config::joined(", ", sql_name(column.name));
    }
    return config::joined(sql, " FROM ", sql_name(plan.name), " ORDER BY fid");
}

}  // namespace

StoredRows::StoredRows(Database& database, const Plan& plan)
    : plan_{plan}, rows_{database, select_statement(plan)}, fields_(plan.columns.size()) {}

bool StoredRows::next() {
    if (!rows_.step()) {
        return false;
    }
    geometry_ = read_geometry(rows_.bytes(0));
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        const int column = static_cast<int>(i) + 1;
        if (rows_.is_null(column)) {
            fields_[i].clear();
        } else if (plan_.columns[i].type == ColumnType::number && rows_.is_number(column)) {
            fields_[i] = config::to_text(rows_.number(column));
        } else {
            fields_[i] = rows_.text(column);
        }
    }
    return true;
}

}  // namespace coupling::geopackage
