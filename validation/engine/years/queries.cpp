#include "validation/engine/years/queries.hpp"

#include <utility>

#include "config/text/joined.hpp"

namespace coupling::validation::years {
namespace {

using config::joined;

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    return first == std::string_view::npos ? std::string_view{}
                                           : text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

/// The parts of a head between bars.
std::vector<std::string> parts_of(std::string_view head) {
    std::vector<std::string> parts;
    for (std::size_t bar = head.find('|'); bar != std::string_view::npos; bar = head.find('|')) {
        parts.emplace_back(trimmed(head.substr(0, bar)));
        head.remove_prefix(bar + 1);
    }
    parts.emplace_back(trimmed(head));
    return parts;
}

/// A kind of head and where its parts go.
struct Head {
    std::string_view word;
    QueryUse use;
    std::vector<std::string Query::*> parts;
    std::string_view form;
    std::size_t optional = 0;  ///< parts at its end that may be missing
};

const std::vector<Head>& heads() {
    using Q = Query;
    static const std::vector<Head> all{
        {"figure ",
         QueryUse::figure,
         {&Q::title, &Q::rows, &Q::label, &Q::unit, &Q::observed},
         "-- figure NAME | TABLE | LABEL | UNIT",
         1},
        {"table ", QueryUse::table, {&Q::title}, "-- table CAPTION"},
        {"stack ", QueryUse::stack, {&Q::title}, "-- stack TITLE"},
        {"lines ", QueryUse::lines, {&Q::title}, "-- lines TITLE"},
        {"warning ", QueryUse::warning, {&Q::rows, &Q::title}, "-- warning FILE | TEXT"},
        {"error ", QueryUse::error, {&Q::rows, &Q::title, &Q::label}, "-- error FILE | FOUND | EXPECTED"}};
    return all;
}

/// Makes of a query what a comment line says it is; other comments say nothing.
void take_head(std::string_view comment, Query& query) {
    for (const Head& head : heads()) {
        if (!comment.starts_with(head.word)) {
            continue;
        }
        const std::vector<std::string> parts = parts_of(comment.substr(head.word.size()));
        query.use = head.use;
        if (parts.size() > head.parts.size() || parts.size() + head.optional < head.parts.size()) {
            config::fail(config::ExitCode::data, query.place,
                         joined("a head of ", std::to_string(parts.size()), " parts"),
                         std::string{head.form});
        }
        for (std::size_t i = 0; i < parts.size(); ++i) {
            query.*head.parts[i] = parts[i];
        }
    }
}

}  // namespace

std::vector<Query> read_queries(std::string_view text, const std::string& file) {
    std::vector<Query> queries;
    Query query;
    for (std::size_t number = 1; !text.empty(); ++number) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = trimmed(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.empty()) {
            continue;
        }
        if (query.sql.empty()) {
            query.place = {file, number, 0};
        }
        const config::Place here{file, number, 0};
        if (line.starts_with("--")) {
            if (!query.sql.empty()) {
                config::fail(config::ExitCode::data, here, "a head inside of a statement",
                             "a semicolon at the end of the statement above");
            }
            take_head(trimmed(line.substr(2)), query);
            continue;
        }
        query.sql += joined(line, "\n");
        if (const std::size_t stop = line.find(';'); stop != std::string::npos && stop + 1 < line.size()) {
            config::fail(config::ExitCode::data, here, "something behind a semicolon",
                         "the end of the line: a statement ends with its last line");
        }
        if (line.ends_with(';')) {
            queries.push_back(std::exchange(query, {}));
        }
    }
    if (!query.sql.empty()) {
        config::fail(config::ExitCode::data, query.place, "a statement without an end",
                     "a semicolon at the end of its last line");
    }
    return queries;
}

std::string filled(const std::string& text, const Fields& fields, const config::Place& place) {
    std::string result;
    std::size_t at = 0;
    for (std::size_t open = text.find('{'); open != std::string::npos; open = text.find('{', at)) {
        const std::size_t close = std::min(text.find('}', open), text.size());
        const std::string column = text.substr(open + 1, close - open - 1);
        const auto field = fields.find(column);
        if (field == fields.end()) {
            config::fail(config::ExitCode::data, place, joined("{", column, "}"),
                         "a column of the table that the head names");
        }
        result += joined(text.substr(at, open - at), field->second);
        at = close + 1;
    }
    return result + text.substr(std::min(at, text.size()));
}

}  // namespace coupling::validation::years
