#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace coupling {

/// What a finished run says of itself in summary.json.
struct SummaryOfRun {
    struct Setting {
        std::string key;
        std::string value;
        std::string unit;
    };
    struct Input {
        std::string role;
        std::string file;
        std::string hash;
    };
    std::string version;
    std::string commit;                  ///< of the program; empty where it is not known
    std::string scenario;                ///< name of the file, without its folder
    std::vector<std::string> overrides;  ///< settings given with --set
    std::string kind;                    ///< "today", "years", "profile", "hazard" or "collapse"
    std::uint64_t seed = 0;
    std::uint64_t rocks = 0;  ///< of a year where there are years; 0 for a collapse
    std::uint32_t years = 0;
    std::uint32_t replicates = 1;
    std::vector<Setting> settings;
    std::vector<Input> inputs;
    std::vector<std::string> warnings;
};

/// In summary.cpp, where summaries are written. Throws config::InputError (data) naming the file for what no
/// run of this program wrote.
SummaryOfRun read_summary(std::string_view text, const std::string& file);

/// The files that a summary.json of any kind of run lists, as paths below its folder. Throws as read_summary.
std::vector<std::string> files_in_summary(std::string_view text, const std::string& file);

/// The folders of the return periods that a hazard map was made of, as paths from that of the map, in its
/// order. Throws as read_summary, and for a summary of another kind.
std::vector<std::string> period_folders_in_summary(std::string_view text, const std::string& file);

}  // namespace coupling
