#include "coupling/results/pack/crate.hpp"

#include "config/errors/input_error.hpp"
#include "config/text/joined.hpp"
#include "coupling/inputs/formats/json_library.hpp"
#include "coupling/results/pack/program_citation.hpp"

namespace coupling::pack {
namespace {

using config::joined;

constexpr const char* program_id = "#bannwald";

std::string title_of(const SummaryOfRun& run, const Citation& citation) {
    return citation.title.empty() ? joined("Rockfall and forest: run of ", run.scenario) : citation.title;
}

std::string licence_url(const std::string& licence) {
    return licence.find("://") == std::string::npos ? joined("https://spdx.org/licenses/", licence) : licence;
}

std::string description_of(const SummaryOfRun& run) {
    return joined("Inputs, settings and results of a run of Bannwald ", run.version,
                  run.commit.empty() ? "" : joined(" (commit ", run.commit, ")"), ", seed ",
                  std::to_string(run.seed),
                  run.years > 0 ? joined(", ", std::to_string(run.years), " years, ",
                                         std::to_string(run.replicates), " replicates")
                                : "",
                  ".");
}

std::string format_of(const std::string& name) {
    const auto ends = [&](const char* ending) { return name.ends_with(ending); };
    return ends(".csv")                    ? "text/csv"
           : ends(".json")                 ? "application/json"
           : ends(".html")                 ? "text/html"
           : ends(".gpkg")                 ? "application/geopackage+sqlite3"
           : ends(".tif") || ends(".tiff") ? "image/tiff"
           : ends(".qml") || ends(".qlr")  ? "text/xml"
           : ends(".gz")                   ? "application/gzip"
           : ends(".shp") || ends(".bin")  ? "application/octet-stream"
                                           : "text/plain";
}

Json reference(const std::string& id) {
    return {{"@id", id}};
}

Json references(const std::vector<DescribedFile>& files) {
    Json list = Json::array();
    for (const DescribedFile& file : files) {
        list.push_back(reference(file.file.name));
    }
    return list;
}

void add_files(Json& graph, const std::vector<DescribedFile>& files) {
    for (const DescribedFile& file : files) {
        graph.push_back({{"@id", file.file.name},
                         {"@type", "File"},
                         {"name", file.file.name.substr(file.file.name.rfind('/') + 1)},
                         {"description", file.sentence},
                         {"contentSize", std::to_string(file.bytes)},
                         {"encodingFormat", format_of(file.file.name)},
                         {"sha256", file.file.sha256}});
    }
}

/// The program that made the results, its authors behind it: what a reader of the archive cites, and where
/// its source is.
void add_program(const SummaryOfRun& run, Json& graph) {
    const ProgramCitation& program = program_citation();
    Json authors = Json::array();
    Json persons = Json::array();
    for (std::size_t i = 0; i < program.authors.size(); ++i) {
        const std::string id = joined("#program-author-", std::to_string(i + 1));
        persons.push_back({{"@id", id}, {"@type", "Organization"}, {"name", program.authors[i]}});
        authors.push_back(reference(id));
    }
    Json entry{{"@id", program_id},
               {"@type", "SoftwareApplication"},
               {"name", "Bannwald"},
               {"description", program.title},
               {"softwareVersion", run.version},
               {"identifier", run.commit},
               {"author", std::move(authors)},
               {"license", reference(licence_url(program.licence))}};
    if (!program.repository.empty()) {
        entry["codeRepository"] = program.repository;
    }
    graph.push_back(std::move(entry));
    for (Json& person : persons) {
        graph.push_back(std::move(person));
    }
}

Json people(const Citation& citation, Json& graph) {
    Json authors = Json::array();
    for (std::size_t i = 0; i < citation.creators.size(); ++i) {
        const std::string id = joined("#creator-", std::to_string(i + 1));
        graph.push_back({{"@id", id}, {"@type", "Person"}, {"name", citation.creators[i]}});
        authors.push_back(reference(id));
    }
    return authors;
}

}  // namespace

std::string program_in_words(const SummaryOfRun& run) {
    const ProgramCitation& program = program_citation();
    std::string text =
        joined("Bannwald ", run.version, run.commit.empty() ? "" : ", commit ", run.commit, ", by ");
    for (std::size_t i = 0; i < program.authors.size(); ++i) {
        text += joined(i == 0 ? "" : "; ", program.authors[i]);
    }
    text += joined(", licence ", program.licence);
    return program.repository.empty() ? text : joined(text, ", source ", program.repository);
}

std::string ro_crate(const SummaryOfRun& run, const Citation& citation, const Repetition& repetition,
                     const std::vector<DescribedFile>& inputs, const std::vector<DescribedFile>& results) {
    Json graph = Json::array();
    graph.push_back({{"@id", "ro-crate-metadata.json"},
                     {"@type", "CreativeWork"},
                     {"conformsTo", reference("https://w3id.org/ro/crate/1.1")},
                     {"about", reference("./")}});
    Json parts = references(inputs);
    for (const Json& part : references(results)) {
        parts.push_back(part);
    }
    Json root{
        {"@id", "./"},
        {"@type", "Dataset"},
        {"name", title_of(run, citation)},
        {"description", description_of(run)},
        {"datePublished", citation.date},
        {"license", citation.licence.empty() ? Json("not stated") : reference(licence_url(citation.licence))},
        {"hasPart", std::move(parts)},
        {"mentions", reference("#run")}};
    Json persons = Json::array();
    if (Json authors = people(citation, persons); !authors.empty()) {
        root["author"] = std::move(authors);
    }
    graph.push_back(std::move(root));
    for (Json& person : persons) {
        graph.push_back(std::move(person));
    }
    add_program(run, graph);
    graph.push_back({{"@id", "#run"},
                     {"@type", "CreateAction"},
                     {"name", repetition.command},
                     {"instrument", reference(program_id)},
                     {"object", references(inputs)},
                     {"result", references(results)}});
    add_files(graph, inputs);
    add_files(graph, results);
    const Json crate{{"@context", "https://w3id.org/ro/crate/1.1/context"}, {"@graph", std::move(graph)}};
    return crate.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string datacite(const SummaryOfRun& run, const Citation& citation, std::uint64_t files,
                     std::uint64_t bytes) {
    Json creators = Json::array();
    for (const std::string& name : citation.creators) {
        creators.push_back({{"name", name}});
    }
    if (creators.empty()) {
        creators.push_back({{"name", "(:unkn)"}});
    }
    Json json{{"schemaVersion", "http://datacite.org/schema/kernel-4"},
              {"identifiers", Json::array()},
              {"creators", std::move(creators)},
              {"titles", {{{"title", title_of(run, citation)}}}},
              {"publisher", "(:tba)"},
              {"publicationYear", citation.date.substr(0, 4)},
              {"types", {{"resourceType", "Simulation run"}, {"resourceTypeGeneral", "Dataset"}}},
              {"dates", {{{"date", citation.date}, {"dateType", "Created"}}}},
              {"sizes", {joined(std::to_string(files), " files"), joined(std::to_string(bytes), " bytes")}},
              {"formats", {"application/zip"}},
              {"descriptions",
               {{{"description", description_of(run)}, {"descriptionType", "Abstract"}},
                {{"description", program_in_words(run)}, {"descriptionType", "TechnicalInfo"}}}}};
    if (!citation.licence.empty()) {
        json["rightsList"] = {{{"rights", citation.licence}, {"rightsUri", licence_url(citation.licence)}}};
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string run_json(const SummaryOfRun& run, const Repetition& repetition) {
    const ProgramCitation& program = program_citation();
    Json json{{"program", "Bannwald"},
              {"version", run.version},
              {"commit", run.commit},
              {"authors", program.authors},
              {"licence", program.licence},
              {"kind", run.kind},
              {"scenario", repetition.scenario},
              {"overrides", run.overrides},
              {"command", repetition.command},
              {"results", "results"},
              {"checksums", manifest_name}};
    if (!program.repository.empty()) {
        json["source"] = program.repository;
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

PackedRun read_run_json(const std::string& text, const std::string& file) {
    try {
        const Json json = Json::parse(text);
        return {json.at("version").get<std::string>(), json.at("commit").get<std::string>(),
                json.value("kind", "today"), json.at("scenario").get<std::string>(),
                json.at("overrides").get<std::vector<std::string>>()};
    } catch (const Json::exception&) {
        config::fail(config::ExitCode::data, {joined(file, ", run.json")}, "no description of a run",
                     "run.json as bannwald pack writes it");
    }
}

}  // namespace coupling::pack
