// sphereview explain: the arithmetic of one pixel, to be checked with pen and paper.
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "app/json.hpp"
#include "app/load_scene.hpp"
#include "app/options.hpp"
#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/output_file.hpp"
#include "base/text.hpp"
#include "exact/explain.hpp"
#include "light/explain_light.hpp"
#include "light/lighting.hpp"
#include "shade/explain_color.hpp"
#include "shade/picture_shader.hpp"

namespace sphereview {

namespace {

// What the shading `studio` knows of a pixel that shows a sphere.
struct PixelLight {
    LightVector sum;
    PixelLights lights;
    std::optional<ExplainedLight> asked;
    ColorExplanation color{};
};

constexpr int digits_of_light = 6;

PixelLight light_of_pixel(const Scene& scene, const ExplainOptions& options, std::int32_t visible, const Light& light,
                          const NumberedLights& lights) {
    const DrawnSpheres drawn = drawn_spheres(scene);
    const Lighting lighting(scene, drawn, scene.camera, options.size, 1, light);
    const LitPixel pixel{scene, drawn, scene.camera, options.size, options.pixel, visible};
    PixelLight found{
        lighting.light({options.pixel.x, options.pixel.y, 1, 1}, {&visible, 1}).front(), explain_lights(pixel, lights), {}, {}};
    if (options.light_to_show) found.asked = explain_light(pixel, lights, *options.light_to_show);
    return found;
}

// "charge = 0.25, chain = 'A'"; "" of a sphere without values.
std::string values_in_words(const Scene& scene, std::size_t sphere) {
    std::vector<std::string> values;
    for (const Property& property : scene.properties) {
        const std::string value = text_at(property, sphere);
        if (!value.empty())
            values.push_back(on_one_line(property.name) + " = " + (is_category(property) ? in_quotes(value) : value));
    }
    return joined(values, ", ");
}

std::string hit_in_words(const Scene& scene, const ExplainedHit& hit) {
    const Sphere& sphere = scene.spheres[static_cast<std::size_t>(hit.number)];
    std::string text;
    const auto line = [&](const std::string& what) { text += "  " + what + "\n"; };
    text += called(scene, hit.number) + ": colour " + in_words(sphere.color) + ", C = " + vector_in_words(sphere.center) +
            ", r = " + shortest(sphere.radius) + "\n";
    if (const std::string values = values_in_words(scene, static_cast<std::size_t>(hit.number)); !values.empty()) line(values);
    const HitInWords words = in_words(hit);
    line("a = D.D                     = " + words.a);
    line("b = 2 D.(O - C)             = " + words.b);
    line("c = (O - C).(O - C) - r^2   = " + words.c);
    line("discriminant = b^2 - 4 a c  = " + words.discriminant + "  " + words.roots);
    line("t1 = (-b - sqrt(discriminant)) / (2 a)  = " + words.t1);
    line("t2 = (-b + sqrt(discriminant)) / (2 a)  = " + words.t2);
    line(why(hit));
    line("t = " + words.t + ", point O + t D = " + words.point + ", normal (point - C) / r = " + words.normal);
    if (hit.as_near_as_last) line("exactly as near as the sphere before it, which comes first in the file");
    return text + "\n";
}

std::string in_words(const ExplainedLight& light, bool main) {
    const std::string name = light.is_sun() ? "sun" : "light " + std::to_string(light.number);
    return name + (main && !light.is_sun() ? ", of the sky's the nearest to the key light" : "") +
           ": L = " + vector_in_words(light.light.direction) + " " + in_words(light.explanation) + "\n";
}

std::string in_words(const PixelLight& light) {
    const auto& [sum, lights, asked, color] = light;
    std::string text = "light: B = (" + std::to_string(sum.x) + ", " + std::to_string(sum.y) + ", " + std::to_string(sum.z) +
                       ") / 2^28, the sum of the lights that shine\n";
    if (lights.sky) text += "sky: " + in_words(*lights.sky) + "\n";
    if (lights.main) text += in_words(*lights.main, true);
    if (asked && asked->number != lights.main->number) text += in_words(*asked, false);
    for (const std::string& line : in_words(color, digits_of_light)) text += line + "\n";
    return text;
}

std::string in_words(const ExplainOptions& options, const std::string& name, const Scene& scene, const PixelExplanation& e,
                     const Background& background, const Color& color, const std::optional<PixelLight>& light) {
    const PictureSize size = options.size;
    std::string text = "pixel " + std::to_string(options.pixel.x) + "," + std::to_string(options.pixel.y) + " of " +
                       on_one_line(name) + " at " + std::to_string(size.width) + "x" + std::to_string(size.height) +
                       " (0,0 is the top left)\n\n";
    text += "ray P = O + t D\n  " + origin_in_words(e) + "\n  " + direction_in_words(e) +
            (e.projection == Projection::perspective ? ", where t = 1\n\n" : "\n\n");
    for (const ExplainedHit& hit : e.hits) text += hit_in_words(scene, hit);
    if (e.farther > 0) text += "and " + std::to_string(e.farther) + " more hits, farther away\n\n";
    text += "not hit: " + std::to_string(e.missed + e.behind) + " of " + std::to_string(scene.spheres.size()) +
            " spheres: " + std::to_string(e.missed) + " missed (discriminant < 0), " + std::to_string(e.behind) +
            " without a positive root (" + behind_in_words(e) + ")";
    if (e.hidden > 0) text += "; hidden: " + std::to_string(e.hidden);
    text += "\n\n";
    const std::int32_t visible = e.visible();
    if (visible < 0) {
        text += "visible: no sphere\ncolour: the background, " + to_string(background) + "\n";
    } else {
        const bool tie = e.hits.size() > 1 && e.hits[1].as_near_as_last;
        text += "visible: " + called(scene, visible) + ", which has the smallest t" +
                (tie ? " and comes first in the file of those that have it" : "") + "\n";
        const std::string shaded =
            options.shading == Shading::flat ? "" : " (--shade " + std::string(name_of(options.shading)) + ")";
        if (light) text += in_words(*light);
        text += "colour: " + in_words(color) + shaded + "\n";
    }
    return text + "decided: " + level_in_words(e.level) + "\n";
}

// JSON has no infinity: null where a double cannot hold the number.
Json number(double value) { return std::isfinite(value) ? Json(value + 0.0) : Json(nullptr); }  // -0 becomes 0
Json vector(const glm::dvec3& v) { return {number(v.x), number(v.y), number(v.z)}; }

Json values_of_sphere(const Scene& scene, std::size_t sphere) {
    Json values = Json::object();
    for (const Property& property : scene.properties) {
        const std::string text = text_at(property, sphere);
        values.set(property.name, text.empty()            ? Json(nullptr)
                                  : is_category(property) ? Json(text)
                                                          : number(number_at(property, sphere)));
    }
    return values;
}

Json to_json(const Scene& scene, const ExplainedHit& hit) {
    const Sphere& sphere = scene.spheres[static_cast<std::size_t>(hit.number)];
    const auto name = scene.names.find(static_cast<std::uint32_t>(hit.number));
    Json json = {{"sphere", hit.number},
                 {"name", name == scene.names.end() ? Json(nullptr) : Json(name->second)},
                 {"color", rgb(sphere.color)},
                 {"center", vector(sphere.center)},
                 {"radius", sphere.radius},
                 {"eye", hit.eye == EyeSide::outside  ? "outside"
                         : hit.eye == EyeSide::inside ? "inside"
                                                      : "on the surface"},
                 {"a", number(hit.a)},
                 {"b", number(hit.b)},
                 {"c", number(hit.c)},
                 {"discriminant", number(hit.discriminant)},
                 {"discriminant_sign", hit.discriminant_sign},
                 {"t1", number(hit.t1)},
                 {"t2", number(hit.t2)},
                 {"counts", hit.counts == CountingRoot::t1 ? "t1" : "t2"},
                 {"why", why(hit)},
                 {"t", number(hit.t)},
                 {"point", vector(hit.point)},
                 {"normal", vector(hit.normal)},
                 {"as_near_as_last", hit.as_near_as_last}};
    if (!scene.properties.empty()) json.set("properties", values_of_sphere(scene, static_cast<std::size_t>(hit.number)));
    return json;
}

Json to_json(const LightVector& light) { return {light.x, light.y, light.z}; }

// `share`: whether to say what the light adds where it shines.
Json to_json(const ExplainedLight& light, bool share) {
    const LightExplanation& e = light.explanation;
    Json json = {{"direction", vector(light.light.direction)},
                 {"shines", e.shines()},
                 {"facing_sign", e.facing},
                 {"blocker", e.blocker ? Json(*e.blocker) : Json(nullptr)},
                 {"along_sign", e.blocker ? Json(e.signs.along) : Json(nullptr)},
                 {"disc_sign", e.blocker ? Json(e.signs.disc) : Json(nullptr)}};
    if (share) json.set("number", light.number);
    if (share) json.set("share", to_json(light.light.share));
    return json;
}

Json to_json(const ExplainOptions& options, const std::string& name, const Scene& scene, const PixelExplanation& e,
             const Color& color, const std::optional<PixelLight>& light) {
    Json hits = Json::array();
    for (const ExplainedHit& hit : e.hits) hits.push_back(to_json(scene, hit));
    const std::int32_t visible = e.visible();
    const char* level = e.level == DecisionLevel::in_float ? "float" : e.level == DecisionLevel::in_double ? "double" : "exact";
    Json json = {{"scene", name},
                 {"pixel", {options.pixel.x, options.pixel.y}},
                 {"size", {options.size.width, options.size.height}},
                 {"projection", name_of(e.projection)},
                 {"origin", vector(e.origin)},
                 {"direction", vector(e.direction)},
                 {"hits", hits},
                 {"farther_hits", e.farther},
                 {"missed", e.missed},
                 {"behind", e.behind},
                 {"hidden", e.hidden},
                 {"visible", visible < 0 ? Json(nullptr) : Json(visible)},
                 {"shade", name_of(options.shading)},
                 {"color", rgb(color)},
                 {"decided_in", level}};
    if (!light) return json;
    const auto& [sum, lights, asked, shown] = *light;
    json.set("light", to_json(sum));
    json.set("brightness", number(shown.brightness));
    json.set("shown_part", number(shown.part));
    if (lights.sky) {
        Json blockers = Json::array();
        for (const auto& [sphere, lights] : lights.sky->blockers) blockers.push_back({{"sphere", sphere}, {"lights", lights}});
        json.set("sky", {{"lights", lights.sky->lights},
                         {"shine", lights.sky->shining},
                         {"behind", lights.sky->behind},
                         {"in_shadow", lights.sky->blocked},
                         {"blockers", blockers}});
    }
    if (lights.main && lights.main->is_sun()) json.set("sun", to_json(*lights.main, false));
    if (asked) {
        json.set("explained_light", to_json(*asked, true));
    } else if (lights.main && !lights.main->is_sun()) {
        json.set("explained_light", to_json(*lights.main, true));
    }
    return json;
}

}  // namespace

std::string explain(const Scene& scene, const std::string& name, const ExplainOptions& options) {
    const PixelExplanation explanation =
        explain_pixel(scene, drawn_spheres(scene), scene.camera, options.size, options.pixel, nullptr, most_hits_listed);
    const Background background = options.background.value_or(scene.background);
    const PictureShader shader(scene, scene.camera, options.size, options.shading, background);
    std::optional<PixelLight> light;
    if (is_lit(options.shading)) {
        const Light of_scene = with_options(scene, options.light);
        const NumberedLights lights(of_scene, scene.spheres.size(), scene.camera);
        if (const std::optional<int> number = options.light_to_show; number && !lights.has(*number)) {
            throw InputError("sphereview: --light: found " + std::to_string(*number) + ", expected " + lights.numbers_in_words());
        }
        if (explanation.visible() >= 0) {
            light = light_of_pixel(scene, options, explanation.visible(), of_scene, lights);
            light->color = explain_color(scene, scene.camera, options.size, options.pixel, explanation.hits.front(),
                                         explanation.direction, light->sum);
        }
    }
    const Color color = shader.color(options.pixel, explanation.visible(), light ? light->sum : LightVector{});
    return options.json ? to_json(options, name, scene, explanation, color, light).dump() + "\n"
                        : in_words(options, name, scene, explanation, background, color, light);
}

ExitCode run_explain(const ExplainOptions& options) {
    const LoadedScene loaded = load_scene(options.scene, {.data = options.data, .look = options.look, .fit = options.fit});
    say_warnings(loaded);
    require_properties(loaded, options.data);
    write_output(std::string(standard_stream), explain(loaded.scene, loaded.name, options));
    return ExitCode::done;
}

}  // namespace sphereview
