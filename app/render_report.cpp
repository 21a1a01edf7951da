#include "app/render_report.hpp"

#include <array>
#include <cstdio>

#include "app/frame_sequence.hpp"
#include "app/json.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "base/standard_streams.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

Json to_json(const RenderReport& report, const RenderOptions& options) {
    Json timings;
    for (std::size_t i = 0; i < phase_names.size(); ++i) timings.set(phase_names[i], report.timings[static_cast<Phase>(i)]);
    Json json = {
        {"scene", report.job.scene_label},
        {"status", static_cast<int>(report.status)},
        {"error", report.error.empty() ? Json(nullptr) : Json(report.error)},
        {"warnings", report.warnings},
        {"notes", report.notes},
        {"output", report.job.output},
        {"size", {options.size.width, options.size.height}},
        {"samples", options.samples},
        {"shade", name_of(options.shading)},
        {"spheres", report.spheres},
        {"properties", report.properties},
        {"backend", report.backend.empty() ? Json(nullptr) : Json(report.backend)},
        {"renderer", report.renderer.empty() ? Json(nullptr) : Json(report.renderer)},
        {"passed_over", report.passed_over},
        {"decided",
         {{"float", report.facts.decisions.in_float},
          {"double", report.facts.decisions.in_double},
          {"exact", report.facts.decisions.exactly}}},
        {"spheres_in", report.facts.spheres_in.empty() ? Json(nullptr) : Json(report.facts.spheres_in)},
        {"tiles",
         {{"sides", report.facts.tile_sides},
          {"candidates", report.facts.candidates},
          {"longest_list", report.facts.longest_list}}},
        {"timings_ms", timings},
    };
    if (options.look.any()) json.update(to_json(report.look));
    if (report.job.sequence) json.set("frame", report.job.sequence->shots()[report.job.shot].number);
    if (report.comparison) {
        const Comparison& comparison = *report.comparison;
        const bool has_first = comparison.different_pixels > 0;
        json.set("comparison", {{"expected", report.job.expect},
                                {"equal", comparison.equal()},
                                {"same_size", comparison.same_size()},
                                {"different_pixels", comparison.different_pixels},
                                {"largest_difference", comparison.largest},
                                {"first", has_first ? Json{comparison.first_x, comparison.first_y} : Json(nullptr)}});
    }
    return json;
}

void print_backend(const RenderReport& report, const RenderOptions& options) {
    std::string line = report.job.label + ": backend: " + report.renderer;
    if (!report.passed_over.empty()) line += "; passed over: " + joined(report.passed_over, "; ");
    if (options.shading != Shading::flat) line += "; shaded: " + std::string(name_of(options.shading));
    say(line);
}

// Tiles and decisions are of points where a pixel has several.
std::string unit_of(const RenderOptions& options) {
    return options.samples == 1 ? "pixels" : "points (" + std::to_string(options.samples) + " a pixel)";
}

// "NAME: tiles of 16 and 4 pixels, candidates: 2,600,000, in the longest list: 400; spheres in buffer textures".
void print_tiles(const RenderReport& report, const RenderOptions& options) {
    const PictureFacts& facts = report.facts;
    if (facts.spheres_in.empty()) return;
    std::vector<std::string> sides;
    for (const int side : facts.tile_sides) sides.push_back(std::to_string(side));
    const std::string tiles = sides.empty() ? "no sphere is in the picture"
                                            : "tiles of " + listed(sides, "and") + (options.samples == 1 ? " pixels" : " points");
    say(report.job.label + ": " + tiles + ", candidates: " + in_groups(facts.candidates) +
        ", in the longest list: " + in_groups(facts.longest_list) + "; spheres in " + facts.spheres_in);
}

// Nothing was counted where best guesses were kept, or nothing was drawn.
void print_decisions(const RenderReport& report, const RenderOptions& options) {
    const DecisionCounts& counts = report.facts.decisions;
    if (counts.in_float + counts.in_double + counts.exactly == 0) return;
    say(report.job.label + ": " + unit_of(options) + " decided: " + std::to_string(counts.in_float) + " in float, " +
        std::to_string(counts.in_double) + " in double, " + std::to_string(counts.exactly) + " exactly");
}

void print_timings(const RenderReport& report) {
    for (std::size_t i = 0; i < phase_names.size(); ++i) {
        std::fprintf(stderr, "%-10s %9s ms\n", std::string(phase_names[i]).c_str(),
                     fixed(report.timings[static_cast<Phase>(i)], 3).c_str());
    }
}

}  // namespace

void print_words(const RenderReport& report, const RenderOptions& options) {
    for (const std::string& note : report.notes) {
        if (options.verbose) say(note);
    }
    if (options.verbose && !report.renderer.empty()) print_backend(report, options);
    if (options.timings) print_timings(report);
    if (options.verbose || options.timings) {
        print_tiles(report, options);
        print_decisions(report, options);
    }
    const auto& sequence = report.job.sequence;
    const bool is_new = !sequence || !sequence->not_said({report.error}).empty();  // else it was said of another frame
    if (!report.error.empty() && is_new) std::fprintf(stderr, "%s\n", report.error.c_str());
}

void print_json(const RenderReport& report, const RenderOptions& options) {
    write_output(std::string(standard_stream), to_json(report, options).dump() + "\n");
}

}  // namespace sphereview
