#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "config/errors/warnings.hpp"
#include "coupling/inputs/site.hpp"
#include "coupling/results/disk/out_file.hpp"

namespace coupling {
struct Scenario;
}

namespace coupling::report {

// Pieces that the pages of all kinds of runs share.

/// An entry of a `<dl class="facts">`; `value` is HTML.
std::string fact(std::string_view name, const std::string& value);
/// The law of rock sizes in words.
std::string rock_size(const Scenario& scenario);

/// The motion model, and what its energies are made of.
std::string motion_in_words(const Scenario& scenario);
/// All warnings and, under a heading of their own, all notes: for the section of that name.
std::string list_of_warnings(const config::Warnings& warnings);
/// Settings by section; those that `is_shown` refuses are left out.
/// The settings that differ from their defaults under a heading, and all of them folded.
std::string settings_section(const Scenario& scenario,
                             const std::function<bool(const std::string&)>& is_shown);

std::string table_of_settings(const Scenario& scenario,
                              const std::function<bool(const std::string&)>& is_shown);
std::string table_of_inputs(const std::vector<InputFile>& inputs);
std::string table_of_files(std::string_view caption, const std::vector<WrittenFile>& files);
/// How to cite the program and the model.
std::string citation(const std::string& version, const Scenario& scenario);

}  // namespace coupling::report
