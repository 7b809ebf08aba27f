#include "coupling/inputs/reading/declared_tables.hpp"

#include <filesystem>

#include "config/text/joined.hpp"
#include "coupling/inputs/formats/layer_name.hpp"
#include "coupling/inputs/tables/meant_columns.hpp"
#include "coupling/inputs/tables/needed_columns.hpp"

namespace coupling {

void check_columns(const config::Table& table, const config::TableSchema& schema, Reading& reading) {
    config::Problems problems;
    require_columns(table, schema, problems);
    problems.throw_if_any();
    for (const config::Problem& problem : misspelt_columns(table, schema.names(), schema.rules().role)) {
        if (!schema.rules().others_refused) {  // else each of them is an error
            reading.warn(problem.place, problem.found, problem.expected);
        }
    }
}

config::Table table_of(const config::TableSchema& schema, const std::string& name, Reading& reading,
                       const std::string& id_opening) {
    config::Table table = reading.table(schema.rules().setting, schema.rules().role, name, id_opening);
    check_columns(table, schema, reading);
    return table;
}

std::vector<NamedTable> tables_in(const std::string& value) {
    std::vector<NamedTable> tables;
    const std::vector<std::string> names = list_of_files(value);
    for (const std::string& name : names) {
        const formats::LayerName layer = formats::split_layer_name(name);
        const std::string stem =
            layer.layer.empty() ? std::filesystem::path{layer.file}.stem().string() : layer.layer;
        tables.push_back({name, names.size() > 1 ? config::joined(stem, "_") : std::string{}});
    }
    return tables;
}

std::string shown_tables(const std::string& value, const Reading& reading) {
    const std::vector<std::string> names = list_of_files(value);
    const std::string first = names.empty() ? std::string{} : reading.shown(names.front());
    return names.size() < 2 ? first : config::joined(first, " (+", std::to_string(names.size() - 1), ")");
}

}  // namespace coupling
