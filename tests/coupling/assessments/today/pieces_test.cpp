#include "coupling/assessments/today/pieces.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "config/errors/input_error.hpp"
#include "tests/coupling/inputs/sample_project.hpp"

namespace coupling::pieces_test {
namespace {

std::vector<rockfall::ReleaseSource> any_sources() {
    std::vector<rockfall::ReleaseSource> sources(*rc::gen::inRange(1, 40));
    for (rockfall::ReleaseSource& source : sources) {
        source.rocks = static_cast<std::uint32_t>(*rc::gen::inRange(0, 300));
    }
    rockfall::number_rocks(sources);
    return sources;
}

RC_GTEST_PROP(Pieces, AreAllChunksOnceInOrderAndPartNoSource, ()) {
    const std::vector<rockfall::ReleaseSource> sources = any_sources();
    const auto chunks = rockfall::plan_chunks(sources, static_cast<std::uint32_t>(*rc::gen::inRange(1, 100)));
    const auto count = static_cast<std::uint32_t>(*rc::gen::inRange(1, 12));
    const rockfall::Chunk* next = chunks.data();
    for (std::uint32_t number = 0; number < count; ++number) {
        const auto piece = chunks_of(chunks, {number, count});
        if (piece.empty()) {
            continue;
        }
        RC_ASSERT(piece.data() == next);
        RC_ASSERT(piece.front().first_rock == sources[piece.front().first_source].first_rock);
        RC_ASSERT(piece.back().whole_sources || piece.back().last_piece);
        next = piece.data() + piece.size();
    }
    RC_ASSERT(next == chunks.data() + chunks.size());
}

TEST(Pieces, AreOfAboutAsManyRocks) {
    std::vector<rockfall::ReleaseSource> sources(1000);
    for (rockfall::ReleaseSource& source : sources) {
        source.rocks = 20;
    }
    rockfall::number_rocks(sources);
    const auto chunks = rockfall::plan_chunks(sources, 100);
    for (std::uint32_t number = 0; number < 7; ++number) {
        const auto piece = chunks_of(chunks, {number, 7});
        const auto rocks = static_cast<double>(piece.back().last_rock - piece.front().first_rock);
        EXPECT_NEAR(rocks, 20'000.0 / 7.0, 100.0);  // a chunk
    }
}

TEST(Pieces, AreFoundByTheirFolders) {
    const SampleProject project;
    const std::filesystem::path parts = project.file("parts");
    EXPECT_FALSE(pieces_in(parts));
    const auto make = [&](const Piece& piece) {
        std::filesystem::create_directories(folder_of(parts, piece));
        project.write(folder_of("parts", piece).string() + "/checkpoint.part", "x");
    };
    std::filesystem::create_directories(folder_of(parts, {0, 9}));  // nothing kept in it
    EXPECT_FALSE(pieces_in(parts));
    make({1, 3});
    make({2, 3});
    EXPECT_EQ(pieces_in(parts), 3U);
    EXPECT_THROW(all_pieces({&parts, 1}), config::InputError);
    make({0, 3});
    EXPECT_EQ(all_pieces({&parts, 1}).size(), 3U);
    make({0, 4});
    EXPECT_THROW((void)pieces_in(parts), config::InputError);
}

}  // namespace
}  // namespace coupling::pieces_test
