#include "app/render_report.hpp"

#include <cstdio>

#include "app/json.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "base/text.hpp"

namespace sphereview {

namespace {

Json to_json(const RenderReport& report) {
    Json timings;
    for (std::size_t i = 0; i < phase_names.size(); ++i) timings.set(phase_names[i], report.timings[static_cast<Phase>(i)]);
    Json json = {
        {"scene", report.job.label},
        {"status", static_cast<int>(report.status)},
        {"error", report.error.empty() ? Json(nullptr) : Json(report.error)},
        {"output", report.job.output},
        {"size", {report.size.width, report.size.height}},
        {"samples", report.samples},
        {"shade", name_of(report.shading)},
        {"spheres", report.spheres},
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

void print_backend(const RenderReport& report) {
    std::string line = report.job.label + ": backend: " + report.renderer;
    for (std::size_t i = 0; i < report.passed_over.size(); ++i) line += (i == 0 ? "; passed over: " : "; ") + report.passed_over[i];
    if (report.shading != Shading::flat) line += "; shaded: " + std::string(name_of(report.shading));
    std::fprintf(stderr, "%s\n", line.c_str());
}

// Tiles and decisions are of points where a pixel has several.
std::string unit_of(const RenderReport& report) {
    return report.samples == 1 ? "pixels" : "points (" + std::to_string(report.samples) + " a pixel)";
}

// "NAME: tiles of 16 and 4 pixels, candidates: 2,600,000, in the longest list: 400; spheres in buffer textures".
void print_tiles(const RenderReport& report) {
    const PictureFacts& facts = report.facts;
    if (facts.spheres_in.empty()) return;
    std::string sides;
    for (std::size_t i = 0; i < facts.tile_sides.size(); ++i) {
        const char* const joint = i == 0 ? "" : i + 1 == facts.tile_sides.size() ? " and " : ", ";
        sides += joint + std::to_string(facts.tile_sides[i]);
    }
    const std::string tiles =
        sides.empty() ? "no sphere is in the picture" : "tiles of " + sides + (report.samples == 1 ? " pixels" : " points");
    std::fprintf(stderr, "%s: %s, candidates: %s, in the longest list: %s; spheres in %s\n", report.job.label.c_str(),
                 tiles.c_str(), in_groups(facts.candidates).c_str(), in_groups(facts.longest_list).c_str(),
                 facts.spheres_in.c_str());
}

// Nothing was counted where best guesses were kept, or nothing was drawn.
void print_decisions(const RenderReport& report) {
    const DecisionCounts& counts = report.facts.decisions;
    if (counts.in_float + counts.in_double + counts.exactly == 0) return;
    std::fprintf(stderr, "%s: %s decided: %lld in float, %lld in double, %lld exactly\n", report.job.label.c_str(),
                 unit_of(report).c_str(), static_cast<long long>(counts.in_float), static_cast<long long>(counts.in_double),
                 static_cast<long long>(counts.exactly));
}

void print_timings(const RenderReport& report) {
    for (std::size_t i = 0; i < phase_names.size(); ++i) {
        std::fprintf(stderr, "%-10s %9s ms\n", std::string(phase_names[i]).c_str(),
                     fixed(report.timings[static_cast<Phase>(i)], 3).c_str());
    }
}

}  // namespace

void print_words(const RenderReport& report, const RenderOptions& options) {
    if (options.verbose && !report.renderer.empty()) print_backend(report);
    if (options.timings) print_timings(report);
    if (options.verbose || options.timings) {
        print_tiles(report);
        print_decisions(report);
    }
    if (!report.error.empty()) std::fprintf(stderr, "%s\n", report.error.c_str());
}

void print_json(const RenderReport& report) { write_output(std::string(standard_stream), to_json(report).dump() + "\n"); }

}  // namespace sphereview
