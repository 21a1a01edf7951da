// The scenes on which all renderers are compared with the oracle.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "oracle/random.hpp"
#include "scene/scene.hpp"

namespace sphereview::oracle {

struct Trial {
    std::string name;  // with the seed where chance was involved
    Scene scene;
    PictureSize size;
};

using Trials = std::vector<Trial>;

// SPHEREVIEW_SEED, or the default.
std::uint64_t seed();

// A sanitised build is many times slower: it takes every tenth.
bool is_sampled(std::size_t index);

// Valid cameras: any place, orientation, size and shift of the screen.
Camera random_camera(Random& random, double scale);

// What anyone might draw: 1 to 40 spheres of all sizes, before, around and behind any camera.
Trial random_trial(std::uint64_t seed);

// Few, small, whole numbers: tangent rays, equal depths and surfaces through the eye come by themselves.
Trial lattice_trial(std::uint64_t seed);

// Silhouettes, crossings and surfaces that miss a pixel's ray, each other or the eye by next to nothing.
Trial near_miss_trial(std::uint64_t seed);

// Any bit pattern for any number.
Trial bit_pattern_trial(std::uint64_t seed);

// The scenes of any maker, and of one of their own, seen by an orthographic camera: silhouettes and surfaces that miss a parallel
// ray or where it begins by next to nothing.
Trial orthographic(Trial trial);
Trial parallel_near_miss_trial(std::uint64_t seed);

// Made by hand: touching (tangent rays, ties, the eye on surfaces) and range (tiny, huge, hidden, odd sizes).
Trials touching_trials();
Trials range_trials();

// So many spheres between which double cannot choose at most pixels, of each kind that is known.
Trials stress_trials(int count, PictureSize size);

// What lists of spheres by screen tiles may get wrong.
Trials tile_trials();

// Many small spheres and some huge ones: lists of tiles of several sizes.
Trial crowded_tiles_trial(PictureSize size, int small, int huge);

}  // namespace sphereview::oracle
