#include "forest/species.hpp"

#include <gtest/gtest.h>

namespace forest {
namespace {

TEST(SpeciesId, IsAnIndex) {
    EXPECT_EQ(index_of(SpeciesId{3}), 3U);
}

}  // namespace
}  // namespace forest
