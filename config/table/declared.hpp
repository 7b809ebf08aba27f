#pragma once

/// Names of what config/table/schema.hpp has, for headers that only mention the columns of a table.
namespace config {

class TableSchema;
template <class Row>
class Schema;

}  // namespace config
