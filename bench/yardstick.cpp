// The textbook ray tracer that the others are measured against: one thread, doubles, every sphere for every pixel, the
// quadratic as in the book, stb's own compressor. usage: yardstick SCENE.txt OUT.png [WIDTH HEIGHT]
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <vector>

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb_image_write.h>

namespace {

struct Vector {
    double x, y, z;
};

double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

struct Sphere {
    int r, g, b;
    Vector center;
    double radius;
};

// The smallest positive t at which the ray from (0, 0, 0) along d meets the sphere; infinity when there is none.
double hit(const Vector& d, const Sphere& sphere) {
    const Vector to_eye = {-sphere.center.x, -sphere.center.y, -sphere.center.z};
    const double a = dot(d, d);
    const double b = 2.0 * dot(d, to_eye);
    const double c = dot(to_eye, to_eye) - sphere.radius * sphere.radius;
    const double discriminant = b * b - 4.0 * a * c;
    if (discriminant < 0.0) return std::numeric_limits<double>::infinity();
    const double root = std::sqrt(discriminant);
    const double t1 = (-b - root) / (2.0 * a);
    const double t2 = (-b + root) / (2.0 * a);
    if (t1 > 0.0) return t1;
    return t2 > 0.0 ? t2 : std::numeric_limits<double>::infinity();
}

bool read_scene(const char* path, std::vector<Sphere>& spheres) {
    std::ifstream file(path);
    std::size_t count = 0;
    if (!(file >> count)) return false;
    for (std::size_t i = 0; i < count; ++i) {
        Sphere s{};
        file >> s.r >> s.g >> s.b >> s.center.x >> s.center.y >> s.center.z >> s.radius;
        if (!file) return false;
        spheres.push_back(s);
    }
    return true;
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<Sphere> spheres;
    if ((argc != 3 && argc != 5) || !read_scene(argv[1], spheres)) {
        std::fprintf(stderr, "usage: yardstick SCENE.txt OUT.png [WIDTH HEIGHT]\n");
        return 2;
    }
    const int width = argc == 5 ? std::atoi(argv[3]) : 1000;
    const int height = argc == 5 ? std::atoi(argv[4]) : 1000;
    const double shorter = width < height ? width : height;

    std::vector<unsigned char> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3);
    unsigned char* out = pixels.data();
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) {
            const Vector d = {50.0 * (2 * i + 1 - width) / shorter, 50.0 * (height - 1 - 2 * j) / shorter, 100.0};
            double nearest = std::numeric_limits<double>::infinity();
            const Sphere* seen = nullptr;
            for (const Sphere& sphere : spheres) {
                const double t = hit(d, sphere);
                if (t < nearest) {
                    nearest = t;
                    seen = &sphere;
                }
            }
            *out++ = static_cast<unsigned char>(seen != nullptr ? seen->r : 0);
            *out++ = static_cast<unsigned char>(seen != nullptr ? seen->g : 0);
            *out++ = static_cast<unsigned char>(seen != nullptr ? seen->b : 0);
        }
    }
    if (stbi_write_png(argv[2], width, height, 3, pixels.data(), 0) == 0) {
        std::fprintf(stderr, "yardstick: %s cannot be written\n", argv[2]);
        return 4;
    }
    return 0;
}
