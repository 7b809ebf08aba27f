#include "validation/engine/write_results.hpp"

#include <algorithm>
#include <functional>

#include "validation/engine/page/page.hpp"
#include "validation/engine/summary_table.hpp"
#include "validation/engine/tables.hpp"

namespace coupling::validation {

namespace {

/// A file of the results: its name, what it holds, who writes it.
struct ResultFile {
    std::string name;
    std::string sentence;
    std::function<void(std::ostream&, std::span<const CaseResult>)> write;
    bool of_variants = false;  ///< empty for cases with one set of settings, such as those of the forest
};

/// The summary comes last: where it is, the results are whole.
const std::vector<ResultFile>& files() {
    static const std::vector<ResultFile> list{
        {"report.html", "everything, with charts", write_validation_page},
        {"verdicts.csv", "every figure beside observed and published, with its criterion", write_verdicts},
        {"figures.csv", "every figure of every variant", write_figures},
        {"choices.csv", "the same figures under every moved choice", write_choices, true},
        {"run_out.csv", "share of rocks that get further than each distance", write_run_out, true},
        {"jumps.csv", "lengths of jumps by 10 m of slope length", write_jumps, true},
        {"tree_hits.csv", "share of rocks by number of tree hits", write_tree_hits, true},
        {"hit_heights.csv", "share of tree hits by height", write_hit_heights, true},
        {"factors.csv", "forest effects over combinations of settings", write_factors, true},
        {"directions.csv", "how figures go as settings grow, beside the literature", write_directions, true},
        {"plots.csv", "the points of the plots", write_plots},
        {"overview.md", "how many criteria each case meets", write_overview},
        {"summary.md", "the verdicts as a text", write_summary},
    };
    return list;
}

}  // namespace

const std::vector<std::string>& result_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all;
        for (const ResultFile& file : files()) {
            all.push_back(file.name);
        }
        return all;
    }();
    return names;
}

std::vector<WrittenFile> write_results(std::span<const CaseResult> cases,
                                       const std::filesystem::path& folder) {
    const bool any_variants =
        std::any_of(cases.begin(), cases.end(), [](const CaseResult& result) { return result.has_strict; });
    std::vector<WrittenFile> written;
    for (const ResultFile& file : files()) {
        if (file.of_variants && !any_variants) {
            continue;
        }
        OutFile out{folder / file.name};
        file.write(out.stream(), cases);
        out.close();
        written.push_back({file.name, file.sentence});
    }
    return written;
}

}  // namespace coupling::validation
