#include "coupling/results/figures/finished_runs.hpp"

#include <algorithm>
#include <optional>
#include <tuple>

#include "config/text/joined.hpp"
#include "config/text/numbers.hpp"
#include "coupling/inputs/files/path_checks.hpp"

namespace coupling {

namespace fs = std::filesystem;
using config::joined;

std::vector<fs::path> finished_runs_in(const fs::path& folder) {
    std::vector<fs::path> runs;
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator{folder, error}) {
        if (is_file(entry.path() / "summary.json")) {
            runs.push_back(entry.path());
        }
    }
    const auto key = [](const fs::path& path) {
        const std::string name = path.filename().string();
        const std::optional<double> number = config::parse_number(
            name.substr(std::min(name.size(), name.find_last_not_of("0123456789.") + 1)));
        return std::tuple{name != "hazard", number.value_or(0.0), name};
    };
    std::sort(runs.begin(), runs.end(),
              [&](const fs::path& a, const fs::path& b) { return key(a) < key(b); });
    return runs;
}

std::string name_a_finished_run(const fs::path& folder) {
    const std::vector<fs::path> runs = finished_runs_in(folder);
    std::string names = "name the folder of a finished run";
    for (std::size_t i = 0; i < runs.size(); ++i) {
        names += joined(i == 0 ? ": " : i + 1 == runs.size() ? " or " : ", ", runs[i].string());
    }
    return names;
}

}  // namespace coupling
