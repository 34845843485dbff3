// Include this for rapidcheck properties: they draw from a fixed seed, so that every run tries the same cases.
// RC_PARAMS in the environment, such as RC_PARAMS="seed=7 max_success=1000", tries others.
#pragma once

#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cstdlib>

namespace atom_map {

inline const int kFixedSeed = setenv("RC_PARAMS", "seed=1", 0);  // read when the first property runs

}  // namespace atom_map
