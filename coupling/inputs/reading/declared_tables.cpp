#include "coupling/inputs/reading/declared_tables.hpp"

#include "coupling/inputs/tables/meant_columns.hpp"

namespace coupling {

void check_columns(const config::Table& table, const config::TableSchema& schema, Reading& reading) {
    schema.require(table);
    for (const config::Problem& problem : misspelt_columns(table, schema.names())) {
        if (!schema.rules().others_refused) {  // else each of them is an error
            reading.warn(problem.place, problem.found, problem.expected);
        }
    }
}

config::Table table_of(const config::TableSchema& schema, const std::string& name, Reading& reading) {
    config::Table table = reading.table(schema.rules().setting, schema.rules().role, name);
    check_columns(table, schema, reading);
    return table;
}

}  // namespace coupling
