#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace faults {

/// A fault of disk_faults.cpp: its mode and the number of the operation.
struct Fault {
    std::string mode = "count";
    long at = 0;
};

/// Whether a fault concerns reads too.
bool counts_reads(const std::string& mode);

/// A change of the disk, or a read, as the library logged it.
struct Operation {
    long number = 0;
    std::string name;
    bool disturbed = false;
    std::filesystem::path path;
};

/// How a call of the program ended.
struct Ending {
    int code = -1;         ///< exit code, if it left by itself
    int signal = 0;        ///< that ended it, or 0
    bool hung = false;     ///< stopped because it did not end
    std::string messages;  ///< standard error
    std::vector<Operation> operations;
};

/// The program under test with the library, in the folder of a project.
struct Program {
    std::filesystem::path program;
    std::filesystem::path library;
    std::filesystem::path project;  ///< current folder of the program
    std::filesystem::path scratch;  ///< for its messages and the log
};

/// Runs the program; what it changes in the project's folder `out` is counted, and the fault takes place
/// there.
Ending run(const Program& program, const std::vector<std::string>& arguments, const Fault& fault);

/// Files below two folders that differ, are missing or too many: "tables/rocks.csv differs".
std::vector<std::string> differences(const std::filesystem::path& expected,
                                     const std::filesystem::path& found);

}  // namespace faults
