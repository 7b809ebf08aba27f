#pragma once

#include <filesystem>
#include <functional>
#include <ostream>
#include <span>
#include <vector>

#include "coupling/inputs/site.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/disk/write_watch.hpp"
#include "coupling/results/geopackage/results_package.hpp"
#include "coupling/results/tables/data_dictionary.hpp"
#include "rockfall/ensemble.hpp"

namespace coupling {

/// What all kinds of run write of themselves, once their own tables and maps lie in the folder.
struct Finish {
    const Scenario& scenario;
    DictionaryOfRun dictionary;  ///< every column of its tables and maps
    std::function<void(std::ostream&, const std::vector<WrittenFile>&)> summary;  ///< summary.json
    std::function<void(std::ostream&, const std::vector<WrittenFile>&)> page;     ///< report.html
    const Site* drawn = nullptr;  ///< what layers are drawn on; none: a run without a map, only the workbook
    StreamedTables streamed{};    ///< tables that were written while rocks fell, and where
    std::span<const rockfall::PathRecord> paths{};
    std::span<const geopackage::AreaLayer> areas{};
};

/// Adds dictionary, GIS files, workbook, summary.json and report.html to a folder, as the scenario wants
/// them, and their names to `files`, which holds what is there. Throws config::InputError (file), and what
/// `watch` throws.
void finish_results(const std::filesystem::path& folder, const Finish& finish,
                    std::vector<WrittenFile>& files, const WriteWatch& watch = {});

/// Turns the tables into those of output.csv = excel, where the scenario wants them: the last step before
/// results are published.
void turn_tables_into_excel(const std::filesystem::path& folder, const Scenario& scenario);

}  // namespace coupling
