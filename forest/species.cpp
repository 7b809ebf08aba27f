#include "forest/species.hpp"
