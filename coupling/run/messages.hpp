#pragma once

#include <filesystem>
#include <span>

#include "config/errors/warnings.hpp"
#include "coupling/inputs/files/input_names.hpp"
#include "coupling/results/disk/out_file.hpp"

namespace coupling {

/// Warnings, the largest effect first, then notes to stderr; of many of a kind the first and their number,
/// all of them if `verbose`. With `names` files elsewhere are called by their paths, as errors call them.
void print_warnings(const config::Warnings& warnings, bool verbose, const InputNames* names = nullptr);

/// The closing lines of a run, which even a quiet one prints: all warnings again, then the number of notes,
/// or all of them if `verbose`.
void repeat_warnings(const config::Warnings& warnings, bool verbose, const InputNames* names = nullptr);

/// To stdout: where the results lie and which files are worth opening, or all of them if `verbose`.
void print_files(const std::filesystem::path& folder, std::span<const WrittenFile> files, bool verbose);

}  // namespace coupling
