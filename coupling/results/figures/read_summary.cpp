#include "coupling/results/figures/read_summary.hpp"

#include "config/errors/input_error.hpp"
#include "coupling/results/figures/json.hpp"

namespace coupling {

SummaryOfRun read_summary(std::string_view text, const std::string& file) {
    try {
        const Json summary = Json::parse(text);
        if (summary.at("program") != "Bannwald") {
            config::fail(config::ExitCode::data, {file}, "a summary of another program", "one of bannwald");
        }
        const Json& run = summary.at("run");
        SummaryOfRun read;
        read.version = summary.at("version").get<std::string>();
        read.commit = summary.value("commit", "");
        read.scenario = run.value("scenario", "");
        read.overrides = summary.value("overrides", std::vector<std::string>{});
        read.kind = run.value("kind", "today");
        read.seed = run.at("seed").get<std::uint64_t>();
        if (read.kind != "collapse") {  // a rock mass has blocks and no number of rocks
            read.rocks = run.contains("rocks") ? run["rocks"].get<std::uint64_t>()
                                               : run.at("rocks_a_year").get<std::uint64_t>();
        }
        read.years = run.value("years", 0U);
        read.replicates = run.value("replicates", 1U);
        for (const Json& setting : summary.at("settings")) {
            const Json& value = setting.at("value");
            read.settings.push_back({setting.at("key").get<std::string>(),
                                     value.is_string() ? value.get<std::string>() : value.dump(),
                                     setting.at("unit").get<std::string>()});
        }
        for (const Json& input : summary.at("inputs")) {
            read.inputs.push_back({input.at("role").get<std::string>(), input.at("file").get<std::string>(),
                                   input.at("hash").get<std::string>()});
        }
        read.warnings = summary.value("warnings", std::vector<std::string>{});
        return read;
    } catch (const Json::exception&) {
        config::fail(config::ExitCode::data, {file}, "no summary of a run",
                     "summary.json as `bannwald run` writes it");
    }
}

std::vector<std::string> files_in_summary(std::string_view text, const std::string& file) {
    try {
        std::vector<std::string> paths;
        const Json summary = Json::parse(text);
        for (const Json& entry : summary.at("files")) {
            paths.push_back(entry.at("path").get<std::string>());
        }
        return paths;
    } catch (const Json::exception&) {
        config::fail(config::ExitCode::data, {file}, "no summary of a run",
                     "summary.json as `bannwald run` writes it");
    }
}

std::vector<std::string> period_folders_in_summary(std::string_view text, const std::string& file) {
    try {
        std::vector<std::string> folders;
        const Json summary = Json::parse(text);
        for (const Json& period : summary.at("return_periods")) {
            folders.push_back(period.at("folder").get<std::string>());
        }
        return folders;
    } catch (const Json::exception&) {
        config::fail(config::ExitCode::data, {file}, "no summary of a hazard map",
                     "summary.json as `bannwald run` writes it");
    }
}

}  // namespace coupling
