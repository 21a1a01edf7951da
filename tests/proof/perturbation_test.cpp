// The bound of docs/exactness.md against arithmetic that errs as much as is assumed of a GPU, in the worst directions that
// a search finds. The filter under test is that of exact/filter.hpp itself, run on perturbed numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include "exact/exact_decision.hpp"
#include "exact/rays.hpp"
#include "proof/filter_model.hpp"
#include "proof/perturbed.hpp"
#include "proof/trial.hpp"
#include "proof/truth.hpp"

namespace sphereview {

namespace {

constexpr double never = NearestHits<double>::never;

// How far the evaluation is on the wrong side of its claims, in scene units; negative while they hold. `side`: what the filter was
// told.
double excess(const Truth& truth, EyeSide side, const HitBounds<Perturbed>& hit, const Rounding& compared) {
    const double low = hit.low.value();
    const double high = hit.high.value();
    const double above_low = low < never ? low - truth.distance : -never;
    const double below_high = high < never ? truth.distance - high : -never;
    const double surely_behind = -compared.last_less();  // -w - along
    switch (side) {
        case EyeSide::inside: return std::max(above_low, below_high);
        case EyeSide::on_surface:
            return truth.hit ? std::max({above_low, below_high, surely_behind}) : compared.greater_from_last(1);
        case EyeSide::in_plane: {
            // h - r - w, and the far root's upper end, the claims to miss; r - h - w, and that a root is before the plane, the
            // claim to hit.
            if (truth.hit) return std::max({above_low, below_high, -compared.last_less(), compared.greater_from_first(0)});
            double before = compared.greater_from_first(2);
            if (compared.greaters() > 3) before = std::max(before, compared.greater_from_first(3));
            return std::min(compared.greater_from_first(1), before);
        }
        case EyeSide::outside: break;
    }
    // The last three: h - r - w, the claim to miss; then r - h - w and along - w, both needed for the claim to hit.
    if (truth.hit) return std::max({above_low, below_high, surely_behind, compared.greater_from_last(3)});
    return std::min(compared.greater_from_last(2), compared.greater_from_last(1));
}

class PerturbedTrial {
public:
    explicit PerturbedTrial(const Trial& trial)
        : truth_(true_hit(trial)),
          side_(trial.camera.orthographic() ? EyeSides(trial.camera)(trial.sphere) : truth_.side),
          frame_(ray_basis<double>(trial.camera, trial.size)),
          coefficients_(ray_coefficients(trial.size, trial.pixel)),
          center_(trial.sphere.center - trial.camera.eye),
          radius_(trial.sphere.radius),
          error_scale_(error_scale(filter_condition(trial.camera), gpu_unit)) {}

    const Truth& truth() const { return truth_; }

    struct Outcome {
        bool holds;
        double excess;
        std::size_t operations;
    };

    // With `factor` times the bound.
    Outcome run(const Rounding::Directions& directions, double factor) const {
        Rounding rounding(directions);
        const auto input = [](const glm::dvec3& v) -> Vector<Perturbed> {
            return {Perturbed::input(v.x), Perturbed::input(v.y), Perturbed::input(v.z)};
        };
        const FilterInputs<Perturbed> inputs = {input(frame_.forward),
                                                input(frame_.right),
                                                input(frame_.up),
                                                Perturbed::input(static_cast<double>(coefficients_.across)),
                                                Perturbed::input(static_cast<double>(coefficients_.upward)),
                                                input(center_),
                                                Perturbed::input(radius_),
                                                Perturbed::input(error_scale_ * factor)};
        const HitBounds<Perturbed> hit =
            frame_.orthographic ? run_parallel_filter(inputs, Perturbed::input(frame_.reach), side_) : run_filter(inputs, side_);
        const bool holds = claims_hold(truth_, hit.low.value(), hit.high.value());
        return {holds, excess(truth_, side_, hit, rounding), rounding.operations()};
    }

    // Reverses errors, one at a time, as long as that makes things worse.
    void worsen(Rounding::Directions& directions, double factor) const {
        constexpr int most_passes = 4;
        Outcome worst = run(directions, factor);
        for (int pass = 0; pass < most_passes; ++pass) {
            const double before = worst.excess;
            for (std::size_t i = 0; i < worst.operations; ++i) {
                const std::int8_t kept = directions[i];
                directions[i] = kept > 0 ? std::int8_t{-1} : std::int8_t{1};
                const Outcome outcome = run(directions, factor);
                if (outcome.excess > worst.excess) {
                    worst = outcome;
                } else {
                    directions[i] = kept;
                }
            }
            if (worst.excess <= before) break;
        }
    }

    // The largest part of the bound, from `low` up, that these errors still break.
    double breaking_factor(const Rounding::Directions& directions, double low) const {
        double high = 2.0;
        for (int step = 0; step < 20; ++step) {
            const double middle = 0.5 * (low + high);
            (run(directions, middle).holds ? high : low) = middle;
        }
        return low;
    }

private:
    Truth truth_;
    EyeSide side_;
    RayBasis<double> frame_;
    RayCoefficients coefficients_;
    glm::dvec3 center_;
    double radius_;
    double error_scale_;
};

// All up, all down, and random ones with some operations exact, as contraction makes them.
enum class Start { up, down, random, mixed, count };

Rounding::Directions starting_directions(Start start, Random& random) {
    Rounding::Directions directions{};
    for (std::int8_t& direction : directions) {
        const auto dice = static_cast<int>(random() % 3) - 1;
        switch (start) {
            case Start::up: direction = 1; break;
            case Start::down: direction = -1; break;
            case Start::random: direction = random() % 2 == 0 ? 1 : -1; break;
            default: direction = static_cast<std::int8_t>(dice); break;
        }
    }
    return directions;
}

constexpr auto kinds = static_cast<std::size_t>(Awkwardness::count);
constexpr std::array<const char*, kinds> kind_names = {"nothing",          "silhouette",         "beside the eye", "inside",
                                                       "near the surface", "through the centre", "on the surface"};

struct Findings {
    int broken = 0;                            // evaluations that broke a claim with the bound times the factor asked for
    std::array<double, kinds> largest_part{};  // of the bound that an evaluation broke
    std::string worst;                         // the trial of the last that was broken
};

enum class Rays { from_the_eye, parallel };

Findings search(Rays rays, std::uint64_t seed, int trials, double factor) {
    Random random(seed);
    Findings findings;
    for (int i = 0; i < trials; ++i) {
        const Trial from_eye = random_trial(random, gpu_unit);
        const Trial trial = rays == Rays::parallel ? with_parallel_rays(from_eye) : from_eye;
        if (camera_fault(trial.camera)) continue;
        const PerturbedTrial perturbed(trial);
        double& largest_part = findings.largest_part.at(static_cast<std::size_t>(trial.awkwardness));
        for (int start = 0; start < static_cast<int>(Start::count); ++start) {
            // Just above what was broken so far: directions that are worst for the whole bound need not be worst there.
            const double probe = std::max(largest_part * 1.001, 0.01);
            Rounding::Directions directions = starting_directions(static_cast<Start>(start), random);
            perturbed.worsen(directions, random() % 2 == 0 ? factor : probe);
            if (!perturbed.run(directions, factor).holds) {
                ++findings.broken;
                findings.worst = to_string(trial);
            }
            if (!perturbed.run(directions, probe).holds) largest_part = perturbed.breaking_factor(directions, probe);
        }
    }
    return findings;
}

void expect_no_claim_is_broken(Rays rays, int trials) {
    const Findings findings = search(rays, test_seed(), trials, 1.0);
    std::printf("%d trials; the largest errors found, as parts of the bound:\n", trials);
    for (std::size_t i = 0; i < kinds; ++i) std::printf("  %-20s %.3f\n", kind_names.at(i), findings.largest_part.at(i));
    EXPECT_EQ(findings.broken, 0) << findings.worst;
    for (const double part : findings.largest_part) EXPECT_LT(part, 1.0);
}

TEST(Perturbation, NoClaimIsBroken) { expect_no_claim_is_broken(Rays::from_the_eye, trial_count(40000)); }

TEST(Perturbation, NoClaimOfParallelRaysIsBroken) { expect_no_claim_is_broken(Rays::parallel, trial_count(20000)); }

// That the search can find what is wrong.
TEST(Perturbation, FindsThatAnEighthOfTheBoundIsTooLittle) {
    EXPECT_GT(search(Rays::from_the_eye, test_seed(), trial_count(10000), 0.125).broken, 0);
    EXPECT_GT(search(Rays::parallel, test_seed(), trial_count(10000), 0.125).broken, 0);
}

// The claims are those of the trials' true sides, which the renderers take from eye_side().
TEST(Perturbation, TrialsAreOfEveryKind) {
    Random random(test_seed());
    std::array<int, 3> sides{};
    int hits = 0;
    int large_conditions = 0;
    constexpr int trials = 1000;
    for (int i = 0; i < trials; ++i) {
        const Trial trial = random_trial(random, gpu_unit);
        const Truth truth = true_hit(trial);
        ++sides.at(static_cast<std::size_t>(truth.side));
        hits += truth.hit ? 1 : 0;
        large_conditions += truth.condition > 16.0 ? 1 : 0;
    }
    for (const int count : sides) EXPECT_GT(count, trials / 20);
    EXPECT_GT(hits, trials / 4);
    EXPECT_LT(hits, trials * 9 / 10);
    EXPECT_GT(large_conditions, trials / 50);
}

}  // namespace

}  // namespace sphereview
