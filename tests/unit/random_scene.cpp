#include "unit/random_scene.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace sphereview {

namespace {

using Random = std::mt19937_64;

double any_double(Random& random) {
    using Limits = std::numeric_limits<double>;
    constexpr std::array special = {0.0,
                                    -0.0,
                                    1.0,
                                    -1.0,
                                    0.1,
                                    1e22,
                                    1e23,
                                    9007199254740993.0,
                                    Limits::max(),
                                    Limits::lowest(),
                                    Limits::min(),
                                    -Limits::min(),
                                    Limits::denorm_min(),
                                    -Limits::denorm_min(),
                                    Limits::epsilon(),
                                    0x0.fffffffffffffp-1022};
    switch (below(random, 5)) {
        case 0: return special[below(random, special.size())];
        case 1: return static_cast<double>(static_cast<std::int64_t>(below(random, 2001)) - 1000) / 10.0;  // as people write
        case 2: return std::bit_cast<double>(random() >> 12 | (random() & 1) << 63);                       // subnormal
        case 3: return std::nextafter(special[below(random, special.size())], one_in(random, 2) ? 1.0 : -1.0);
        default:
            while (true) {
                const auto value = std::bit_cast<double>(random());
                if (std::isfinite(value)) return value;
            }
    }
}

glm::dvec3 any_vector(Random& random) { return {any_double(random), any_double(random), any_double(random)}; }

double any_radius(Random& random) {
    const double radius = std::fabs(any_double(random));
    return radius > 0.0 ? radius : std::numeric_limits<double>::denorm_min();
}

std::string any_name(Random& random) {
    static const std::vector<std::string> pieces = {
        "a",
        "Sun",
        " ",
        "\"",
        "'",
        "\\",
        "\"\"\"",
        "'''",
        "#",
        "=",
        "]",
        "\n",
        "\r\n",
        "\r",
        "\t",
        "\b",
        "\x7F",
        "\x1b[2J",
        "\\n",
        "\\u0041",
        std::string(1, '\0'),
        "\x01",
        "\xC2\x80",          // U+0080, the first of two bytes
        "\xC2\x85",          // U+0085, next line
        "\xE2\x80\xA8",      // U+2028, line separator
        "\xEF\xBB\xBF",      // U+FEFF, byte-order mark
        "\xED\x9F\xBF",      // U+D7FF, the last before the surrogates
        "\xEF\xBF\xBF",      // U+FFFF
        "\xF0\x9F\x8C\x90",  // U+1F310
        "\xF4\x8F\xBF\xBF",  // U+10FFFF, the last
    };
    std::string name;
    const std::size_t length = 1 + below(random, 6);
    for (std::size_t i = 0; i < length; ++i) name += pieces[below(random, pieces.size())];
    return name;
}

Background any_background(Random& random) {
    if (one_in(random, 4)) return {};
    if (one_in(random, 4)) return {{0, 0, 0}, true};
    if (one_in(random, 4)) return {{255, 255, 255}, false};
    return {{static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random()), static_cast<std::uint8_t>(random())}, false};
}

// The default one where the attempt cannot be used.
Camera any_camera(Random& random) {
    Camera camera;
    const double a = any_double(random);
    const double b = any_double(random);
    switch (below(random, 3)) {
        case 0: camera.right = {a, b, -0.0}, camera.up = {-b, a, 0.0}; break;
        case 1: camera.right = {0.0, a, b}, camera.up = {0.0, -b, a}; break;
        default: camera.right = {a, 0.0, b}, camera.up = {-b, -0.0, a}; break;
    }
    camera.eye = any_vector(random);
    camera.center = any_vector(random);
    return camera_fault(camera) ? Camera{} : camera;
}

}  // namespace

Scene random_scene(Random& random) {
    Scene scene;
    scene.background = any_background(random);
    if (!one_in(random, 3)) scene.camera = any_camera(random);
    for (std::size_t i = below(random, 4); i-- > 1;) {
        scene.views.push_back({any_name(random) + std::to_string(i), any_camera(random)});  // no two alike
        if (one_in(random, 2)) scene.views.back().camera.projection = Projection::orthographic;
    }
    // Now and then as many as make the native format hold them as text.
    const bool many = one_in(random, 20);
    const std::size_t count = many ? 1001 + below(random, 100) : below(random, 8);
    const bool plain = many && !one_in(random, 4);
    for (std::size_t i = 0; i < count; ++i) {
        Sphere sphere{any_vector(random), any_radius(random), any_background(random).color, false};
        if (!plain) {
            sphere.hidden = one_in(random, 4);
            if (one_in(random, 2)) scene.names[static_cast<std::uint32_t>(i)] = any_name(random);
        }
        scene.spheres.push_back(sphere);
    }
    return scene;
}

}  // namespace sphereview
