#pragma once

#include <functional>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "config/errors/warnings.hpp"
#include "coupling/assessments/decades/members/records.hpp"
#include "coupling/assessments/decades/tables/decade_tables.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/disk/out_file.hpp"
#include "forest/stand/patch.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::decades {

/// A part of the page; nothing where its HTML is empty.
struct Section {
    std::string heading;  ///< plain
    std::string html;
    bool on_paper = true;  ///< false: shown on screens alone
};

/// What the page of a run over years shows. Everything referred to must live as long as it is written.
struct PageContent {
    const Scenario& scenario;
    Names names;
    const forest::PatchGrid& grid;
    /// Those that ran, in any order; of a regime without members nothing is shown. All have the same years.
    std::span<const MemberYears> members;
    const config::Warnings& warnings;
    const std::vector<InputFile>& inputs;
    const std::vector<WrittenFile>& files;
    std::string version;
    std::string climate;         ///< in words; may be empty
    std::string decision = {};   ///< what stands first: verdict and table, as HTML; may be empty
    std::vector<Section> first;  ///< what stands before the forest, such as its protection over the years
    std::string areas = {};      ///< maps of where regimes act, as HTML; may be empty
    bool has_maps = false;       ///< `first` or `areas` has what all maps refer to
    /// Settings that the page lists, all without it.
    std::function<bool(const std::string&)> shows_setting = {};
    const Site* site = nullptr;  ///< for the view in three dimensions; without it there is none
};

/// The years of a forest as one self-contained HTML page: no outside address, same bytes from the same
/// content. Without scripts all but the view in three dimensions stays.
void write_decade_page(std::ostream& out, const PageContent& content);

}  // namespace coupling::decades
