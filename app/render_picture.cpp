#include "app/render_picture.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "base/error.hpp"
#include "base/parallel.hpp"
#include "cpu/cpu_renderer.hpp"
#include "light/lighting.hpp"
#include "shade/picture_shader.hpp"
#include "tiles/build_lists.hpp"

namespace sphereview {

namespace {

// The colours of a picture's blocks: those of points, averaged where a pixel has several.
class ColoredPicture {
public:
    // What is passed in must outlive it; `picture` has the options' size.
    ColoredPicture(const Scene& scene, const PictureOptions& options, Image picture)
        : options_(options),
          side_(sample_side(options.samples)),
          shader_(scene, options.camera, sampled_size(options.size, side_), options.shading, options.background),
          picture_(std::move(picture)) {}

    const Image& image() const { return picture_; }
    Image take() { return std::move(picture_); }

    void color(const Block& block, std::span<const std::int32_t> visible, std::span<const LightVector> light) {
        if (side_ == 1) {
            shader_.shade(block, visible, picture_, {}, light);
        } else {
            average(block, visible, light);
        }
    }

private:
    // Some rows at a time: their colours stay in the processor's cache.
    void average(const Block& strip, std::span<const std::int32_t> visible, std::span<const LightVector> light) {
        constexpr int points_at_once = 1 << 18;
        const auto width = static_cast<std::size_t>(strip.width);
        const int most_rows = std::max(points_at_once / strip.width / side_, 1) * side_;
        for (int y = 0; y < strip.height; y += most_rows) {
            const Block rows{strip.x, strip.y + y, strip.width, std::min(most_rows, strip.height - y)};
            if (points_.width() != rows.width || points_.height() != rows.height) {
                points_ = make_picture({rows.width, rows.height}, options_.background);
            }
            const std::size_t begin = static_cast<std::size_t>(y) * width;
            const std::size_t count = static_cast<std::size_t>(rows.height) * width;
            shader_.shade(rows, visible.subspan(begin, count), points_, {rows.x, rows.y},
                          light.empty() ? light : light.subspan(begin, count));
            average_into(points_, side_, picture_, rows.x / side_, rows.y / side_);
        }
    }

    const PictureOptions& options_;
    int side_;  // points along a side of a pixel
    PictureShader shader_;
    Image picture_;
    Image points_;  // colours that are not averaged yet
};

// So many rows of a block, from its row y on.
std::span<std::int32_t> rows_of(std::span<std::int32_t> visible, const Block& block, int y, int rows) {
    const auto width = static_cast<std::size_t>(block.width);
    return visible.subspan(static_cast<std::size_t>(y) * width, static_cast<std::size_t>(rows) * width);
}

// What happens to each block of a picture after it was traced. Its pixels are points here, unless something else is said: with
// samples, blocks are those of a picture of `side` times the size, of which only as much as is traced at once is ever there.
class PictureInProgress {
public:
    // `lists` are given back as soon as no pixel is to be decided any more.
    PictureInProgress(const Scene& scene, const DrawnSpheres& drawn, CandidateLists& lists, const PictureOptions& options,
                      Timings& timings, PictureFacts& facts, const std::function<void(double)>& progress, const Drafts* drafts,
                      KeptLight* kept)
        : options_(options),
          side_(sample_side(options.samples)),
          size_(sampled_size(options.size, side_)),
          lists_(lists),
          resolver_(scene, drawn, options.camera, size_, &lists),
          colored_(scene, options,
                   drafts != nullptr && drafts->under.width() > 0 ? drafts->under.copy()
                                                                  : make_picture(options.size, options.background)),
          timings_(timings),
          facts_(facts),
          progress_(progress),
          drafts_(drafts),
          kept_(kept) {
        if (!is_lit(options.shading)) return;
        lighting_.emplace(scene, drawn, options.camera, size_, side_, options.light);
        if (kept_ != nullptr) kept_->begin(lighting_->sets(), side_);
    }

    // Calls trace(block, visible, done) for blocks of at most this size, one after the other, and finishes each. Width and height
    // must be multiples of every sample_side(). Where tracing takes long, trace() calls done() now and then with the part that is.
    template <typename Trace>
    Image draw(int block_width, int block_height, const Trace& trace) {
        // Not a vector: nobody needs its millions of numbers cleared first.
        const auto most = static_cast<std::size_t>(std::min(block_width, size_.width)) *
                          static_cast<std::size_t>(std::min(block_height, size_.height));
        const auto buffer = std::make_unique_for_overwrite<std::int32_t[]>(most);
        for (int y = 0; y < size_.height; y += block_height) {
            for (int x = 0; x < size_.width; x += block_width) {
                const Block block{x, y, std::min(block_width, size_.width - x), std::min(block_height, size_.height - y)};
                const std::span visible(buffer.get(),
                                        static_cast<std::size_t>(block.width) * static_cast<std::size_t>(block.height));
                trace(block, visible, [&](double done) { report(block, part_of_trace() * done); });
                finish(block, visible);
            }
        }
        if (lighting_ && kept_ != nullptr) kept_->finish();
        Image picture = colored_.take();
        draw_marks(options_.marks, options_.camera, picture);
        return picture;
    }

private:
    // With light a block is one batch: whatever the light falls on is asked for all its points at once.
    void finish(const Block& block, std::span<std::int32_t> visible) {
        if (!lighting_) return finish_strips(block, visible, 1.0);
        finish_strips(block, visible, part_of_visibility);
        if (is_last(block)) {  // light takes memory, too
            lists_.begins = {0, 0};
            UninitializedVector<Candidate>().swap(lists_.candidates);
        }
        std::vector<LightVector> light;
        {
            const PhaseTimer timer(timings_, Phase::light);
            const LightPreviews previews{.show =
                                             [&](std::span<const LightVector> some, double) {
                                                 colored_.color(block, visible, some);
                                                 drafts_->show(colored_.image().copy());
                                             },
                                         .fewest = fewest_lights};
            light = lighting_->light(
                block, visible, [&](double done) { report(block, part_of_visibility + (1.0 - part_of_visibility) * done); },
                is_shown(block) ? &previews : nullptr, kept_);
        }
        const PhaseTimer timer(timings_, Phase::resolve);
        colored_.color(block, visible, light);
        if (is_shown(block)) drafts_->show(colored_.image().copy());
    }

    // Whether there is something to see also where nothing is finished.
    bool is_shown(const Block& block) const { return drafts_ != nullptr && (is_last(block) || drafts_->under.width() > 0); }

    bool is_last(const Block& block) const {
        return block.x + block.width == size_.width && block.y + block.height == size_.height;
    }

    void report(const Block& block, double block_part) const {
        progress_((block.y + block.height * (block.x + block_part * block.width) / size_.width) / size_.height);
    }

    // In strips that take about as long as people wait for a sign of life: an exact pixel may cost a thousand times a usual one.
    void finish_strips(const Block& block, std::span<std::int32_t> visible, double end_part) {
        const PhaseTimer timer(timings_, Phase::resolve);
        int rows = first_strip;
        for (int y = 0; y < block.height;) {
            const Block strip{block.x, block.y + y, block.width, std::min(rows, block.height - y)};
            const auto begin = std::chrono::steady_clock::now();
            const auto report_strip = [&](double strip_part) {
                report(block, std::lerp(part_of_trace(), end_part, (y + strip_part * strip.height) / block.height));
            };
            finish_strip(strip, rows_of(visible, block, y, strip.height), report_strip);
            const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
            report_strip(1.0);
            y += strip.height;
            rows = static_cast<int>(std::clamp(rows * std::clamp(0.1 / seconds, 0.1, 16.0), 1.0, 1e6));
            // Whole cells of the resolver's (and whole pixels).
            rows = std::max(rows / fewest_rows, 1) * fewest_rows;
        }
    }

    void finish_strip(const Block& strip, std::span<std::int32_t> visible, const std::function<void(double)>& progress) {
        if (options_.certify) {
            facts_.decisions += resolver_.certify(strip, visible, progress);
        } else {
            resolver_.accept_guesses(visible);
        }
        const auto is_sphere = [](std::int32_t number) { return number != visible_background; };
        facts_.shows_sphere = facts_.shows_sphere || std::ranges::any_of(visible, is_sphere);
        if (!lighting_) colored_.color(strip, visible, {});
    }

    // Blocks that are not lit are small: their trace counts for nothing.
    double part_of_trace() const { return lighting_ ? 0.5 * part_of_visibility : 0.0; }

    static constexpr double part_of_visibility = 0.1;  // of a block that is lit
    static constexpr int fewest_rows = 8;
    static constexpr int first_strip = 64;

    const PictureOptions& options_;
    int side_;          // points along a side of a pixel
    PictureSize size_;  // in points
    CandidateLists& lists_;
    Resolver resolver_;
    std::optional<Lighting> lighting_;  // in the shading that has light
    ColoredPicture colored_;
    Timings& timings_;
    PictureFacts& facts_;
    const std::function<void(double)>& progress_;
    const Drafts* drafts_;
    KeptLight* kept_;
};

// Columns of a CPU block: all of any usual picture. Its 8 rows at least may take so much memory.
constexpr int cpu_block_width = 1 << 18;

// Rows of a CPU block: enough work for all cores, little enough for a progress bar.
int cpu_block_height(PictureSize size, const CandidateLists& lists) {
    constexpr double tests_per_block = 1e8;
    const double in_tile = static_cast<double>(lists.candidates.size()) / static_cast<double>(lists.begins.size());
    const double cells =
        tests_per_block / (static_cast<double>(std::min(size.width, cpu_block_width)) * (in_tile + 10.0) * (1 << cpu_cell_shift));
    return static_cast<int>(std::clamp(cells, 1.0, 1e6)) << cpu_cell_shift;
}

// Rows of a GPU block: what is read back stays in the processor's cache, and the same memory serves all blocks. Touching memory
// for the first time costs more than a draw. Whole tiles of llvmpipe's, which are of 64 pixels.
int gpu_block_height(int block_width, int largest) {
    constexpr int pixels_per_block = 1 << 18;
    return std::min(largest, std::max(64, pixels_per_block / block_width / 64 * 64));
}

// Rows of a block that is lit: lists for each light are worth their time for many points, which take some 100 bytes each.
int lit_block_height(int block_width) {
    constexpr int points_per_block = 1 << 20;
    return std::max(64, points_per_block / block_width / 64 * 64);
}

void describe(const CandidateLists& lists, PictureFacts& facts) {
    facts.tile_sides.clear();
    for (const TileLevel& level : lists.levels) facts.tile_sides.push_back(1 << level.shift);
    facts.candidates = lists.candidates.size();
    facts.longest_list = 0;
    for (std::size_t i = 1; i < lists.begins.size(); ++i) {
        facts.longest_list = std::max<std::size_t>(facts.longest_list, lists.begins[i] - lists.begins[i - 1]);
    }
}

}  // namespace

Image render_picture(OpenBackend& backend, const Scene& scene, const DrawnSpheres& drawn, const PictureOptions& options,
                     Timings& timings, PictureFacts& facts, const std::function<void(double)>& progress, const Drafts* drafts,
                     KeptLight* kept) {
    const PictureSize size = sampled_size(options.size, sample_side(options.samples));
    CandidateLists lists =
        timed(timings, Phase::lists, [&] { return build_lists(drawn, options.camera, size, backend.tile_costs); });
    PictureInProgress picture(scene, drawn, lists, options, timings, facts, progress, drafts, kept);
    describe(lists, facts);
    const bool lit = is_lit(options.shading);
    if (!backend.gpu) {
        facts.spheres_in = "memory";
        const CpuRenderer cpu(drawn, lists, options.camera, size);
        const int width = std::min(cpu_block_width, size.width);
        return picture.draw(cpu_block_width, lit ? lit_block_height(width) : cpu_block_height(size, lists),
                            [&](const Block& block, std::span<std::int32_t> visible, const auto& done) {
                                const PhaseTimer timer(timings, Phase::trace);
                                const int rows = cpu_block_height(size, lists);
                                for (int y = 0; y < block.height; y += rows) {
                                    const Block strip{block.x, block.y + y, block.width, std::min(rows, block.height - y)};
                                    cpu.trace(strip, rows_of(visible, block, y, strip.height));
                                    done(static_cast<double>(y + strip.height) / block.height);
                                }
                            });
    }
    GpuRenderer& gpu = *backend.gpu;
    gpu.upload(drawn, lists, options.camera, size, timings);
    facts.spheres_in = gpu.storage();
    const int side = gpu.largest_block_side() / 4 * 4;  // whole pixels, whatever the samples
    const int width = std::min(side, size.width);
    return picture.draw(
        side, lit ? std::min(side, lit_block_height(width)) : gpu_block_height(width, side),
        [&](const Block& block, std::span<std::int32_t> visible, const auto&) { gpu.trace(block, visible, timings); });
}

std::optional<Image> relit_picture(const Scene& scene, const PictureOptions& options, const KeptLight& kept) {
    const auto sets = light_sets(options.light, scene.spheres.size(), options.camera, sample_side(options.samples));
    const std::optional<KeptLight::Shares> shares = kept.is_complete() ? kept.shares(sets) : std::nullopt;
    if (!shares) return std::nullopt;
    ColoredPicture colored(scene, options, make_picture(options.size, options.background));
    for (const KeptLight::Piece& piece : kept.pieces()) {
        check_cancelled();
        colored.color(piece.block, piece.visible, kept.light(piece, *shares));
    }
    Image picture = colored.take();
    draw_marks(options.marks, options.camera, picture);
    return picture;
}

Image render_by_what_holds_it(OpenBackend& opened, Backend asked_for, const std::function<Image(OpenBackend&)>& render) {
    try {
        return render(opened);
    } catch (const TooLarge& error) {
        if (asked_for != Backend::automatic) {
            throw RenderError("the backend " + opened.description + " cannot hold the scene: " + error.what() +
                              "; use --backend cpu");
        }
        OpenBackend cpu;
        cpu.passed_over = opened.passed_over;
        cpu.passed_over.push_back(opened.description + ": " + error.what());
        return render(cpu);
    }
}

}  // namespace sphereview
