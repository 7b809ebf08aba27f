#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <ostream>
#include <span>
#include <vector>

#include "coupling/assessments/nets/figures/net_figures.hpp"
#include "coupling/inputs/nets/net_record.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "coupling/results/figures/run_results.hpp"
#include "coupling/results/tables/table_layout.hpp"
#include "coupling/results/tables/table_of.hpp"

namespace coupling {

Column net_name_column();

/// energy_mean_kj and so on; `meaning`: "the kinetic energy in front of the net".
ColumnsOf<NetQuantity> net_quantity_columns(const std::string& name, const std::string& ending,
                                            const std::string& meaning);

/// nets.csv, net_needs.csv and net_crossings.csv.
std::vector<TableLayout> net_layouts();
void write_nets(std::ostream& out, std::span<const NetRecord> nets, std::span<const NetFigures> figures,
                const DesignSettings& design);
void write_net_needs(std::ostream& out, std::span<const NetRecord> nets, std::span<const NetFigures> figures);
/// Places come in coordinates of the terrain and are written absolute: `origin_m` is added.
void write_net_crossings(std::ostream& out, std::span<const NetRecord> nets,
                         std::span<const NetRow> crossings, const Eigen::Vector2d& origin_m);

/// The figures of all nets on all assessed slopes, slope by slope.
std::vector<NetFigures> net_figures(const RunResults& results);

/// All three tables into folder/tables; nothing without nets.
std::vector<WrittenFile> write_net_tables(const RunResults& results, const std::filesystem::path& folder);

}  // namespace coupling
