#include "validation/engine/years/standard_queries.hpp"

#include "config/text/embedded.hpp"
#include "config/text/joined.hpp"

BANNWALD_EMBED(standard_queries_sql, BANNWALD_EMBEDDED_FILE)

namespace coupling::validation::years {

using config::joined;

std::vector<Query> standard_queries() {
    return read_queries(BANNWALD_EMBEDDED(standard_queries_sql), "standard_queries.sql");
}

std::vector<Query> queries_of(const CaseFiles& files, const YearsSettings& settings) {
    std::vector<Query> queries = settings.standard ? standard_queries() : std::vector<Query>{};
    const std::string& own = settings.figures;
    if (files.has(own)) {
        std::vector<Query> more = read_queries(files.texts.at(own), files.shown(own));
        queries.insert(queries.end(), more.begin(), more.end());
    }
    if (queries.empty() || (!files.has(own) && own != YearsSettings{}.figures)) {
        config::fail(config::ExitCode::settings, {files.shown("case.ini")},
                     joined("no figures: the folder has no ", own), "the file that years.figures names");
    }
    return queries;
}

}  // namespace coupling::validation::years
