#include "validation/engine/years/standard_queries.hpp"

#include "config/text/embedded.hpp"

BANNWALD_EMBED(standard_queries_sql, BANNWALD_EMBEDDED_FILE)

namespace coupling::validation::years {

std::vector<Query> standard_queries() {
    return read_queries(BANNWALD_EMBEDDED(standard_queries_sql), "standard_queries.sql");
}

}  // namespace coupling::validation::years
