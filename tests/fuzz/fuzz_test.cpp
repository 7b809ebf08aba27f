#include <gtest/gtest.h>
#include <omp.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <exception>
#include <fstream>
#include <iomanip>

#include "config/errors/input_error.hpp"
#include "tests/fuzz/mutate.hpp"
#include "tests/fuzz/subject.hpp"
#include "tests/fuzz/watch.hpp"

namespace fuzz {
namespace {

/// Longest message [bytes]: no one shows a whole file to the user.
constexpr std::size_t longest_message_bytes = 100'000;

std::uint64_t from_environment(const char* name, std::uint64_t otherwise) {
    const char* const text = std::getenv(name);
    return text == nullptr ? otherwise : std::strtoull(text, nullptr, 10);
}

/// One file of a subject.
struct Target {
    Subject subject;
    std::string file;

    [[nodiscard]] std::string name() const { return subject.name + "/" + file; }
};

std::vector<Target> targets_of(const std::vector<std::vector<Subject>>& rooms) {
    std::vector<Target> targets;
    for (const auto& subjects : rooms) {
        for (const Subject& subject : subjects) {
            for (const std::string& file : subject.files) {
                targets.push_back({subject, file});
            }
        }
    }
    return targets;
}

void PrintTo(const Target& target, std::ostream* out) {
    *out << target.name();
}

/// What the inputs of a target came to.
struct Figures {
    std::uint64_t inputs = 0;
    std::uint64_t refused = 0;
    double longest_s = 0.0;
    std::size_t most_bytes = 0;
};

void keep(const Figures& figures, const std::string& name) {
    if (const char* const file = std::getenv("BANNWALD_FUZZ_FIGURES")) {
        std::ofstream{file, std::ios::app} << name << ',' << figures.inputs << ',' << figures.refused << ','
                                           << std::fixed << std::setprecision(3) << figures.longest_s << ','
                                           << std::setprecision(1)
                                           << static_cast<double>(figures.most_bytes) / 1e6 << '\n';
    }
}

/// "" if the reader took the input or refused it in the proper way, else what went wrong.
/// `refused`: with which message it was refused, "" if not.
std::string fault_of(const Target& target, const coupling::SampleProject& project, std::string& refused) {
    refused.clear();
    try {
        target.subject.read(project);
    } catch (const config::InputError& error) {
        refused = error.what();
        if (error.code() == config::ExitCode::internal || error.code() == config::ExitCode::done) {
            return "an error of the user with the code of a fault of the program";
        }
        return std::string{error.what()}.size() > longest_message_bytes ? "a message without end" : "";
    } catch (const std::exception& error) {
        return std::string{"a fault of the program: "} + error.what();
    }
    return "";
}

class EveryReader : public testing::TestWithParam<Target> {};

TEST_P(EveryReader, TakesOrRefusesWhateverItIsGiven) {
    const Target& target = GetParam();
    const std::uint64_t seed = from_environment("BANNWALD_FUZZ_SEED", 1);
    const std::uint64_t first = from_environment("BANNWALD_FUZZ_FIRST", 0);
    const std::uint64_t count = from_environment("BANNWALD_FUZZ_INPUTS", 16);
    omp_set_num_threads(1);
    const std::unique_ptr<coupling::SampleProject> project = target.subject.make();
    std::string refused;
    ASSERT_EQ(fault_of(target, *project, refused), "");
    ASSERT_EQ(refused, "") << target.name() << ": the input that is to be changed must be valid";

    const std::string valid = project->read(target.file);
    Watch watch;
    Figures figures;
    for (std::uint64_t i = first; i < first + count; ++i) {
        Chance chance{seed_of(seed, target.name(), i)};
        project->write(target.file, mutated(valid, chance));
        const std::string repeat = target.name() + ", BANNWALD_FUZZ_SEED=" + std::to_string(seed) +
                                   " BANNWALD_FUZZ_FIRST=" + std::to_string(i) +
                                   " BANNWALD_FUZZ_INPUTS=1; it is in " + project->folder().string();
        watch.begin(repeat);
        const std::string fault = fault_of(target, *project, refused);
        watch.end();
        EXPECT_EQ(fault, "") << repeat;
        EXPECT_LE(watch.grown_bytes(), most_bytes) << repeat;
        ++figures.inputs;
        figures.refused += refused.empty() ? 0 : 1;
        figures.longest_s = std::max(figures.longest_s, watch.cpu_seconds());
        figures.most_bytes = std::max(figures.most_bytes, watch.grown_bytes());
    }
    keep(figures, target.name());
}

std::string as_test_name(const testing::TestParamInfo<Target>& target) {
    std::string name = target.param.name();
    for (char& c : name) {
        c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    }
    return name;
}

INSTANTIATE_TEST_SUITE_P(Fuzz, EveryReader,
                         testing::ValuesIn(targets_of({subjects_of_inputs(), subjects_of_collapse(),
                                                       subjects_of_files(), subjects_of_results()})),
                         as_test_name);
// Each reading of a case opens all its scenarios.
INSTANTIATE_TEST_SUITE_P(LongFuzz, EveryReader, testing::ValuesIn(targets_of({subjects_of_cases()})),
                         as_test_name);

TEST(Mutated, IsTheSameForTheSameSeedAndMostlyAnotherForAnother) {
    const std::string valid = "x_m,y_m\n1,2\n3,4\n";
    std::size_t unchanged = 0;
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
        Chance one{seed};
        Chance two{seed};
        const std::string text = mutated(valid, one);
        EXPECT_EQ(text, mutated(valid, two));
        EXPECT_LE(text.size(), longest_input_bytes);
        unchanged += text == valid ? 1 : 0;
    }
    EXPECT_LT(unchanged, 200U);
}

}  // namespace
}  // namespace fuzz
