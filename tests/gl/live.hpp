// Live pictures in a window that is a texture.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <ranges>

#include "gpu/live_picture.hpp"
#include "image/image.hpp"
#include "support/spheres.hpp"

namespace sphereview::test {

inline constexpr Color red{255, 0, 0};
inline constexpr Color blue{0, 0, 250};

// A red sphere in the middle, and a blue one that covers its right side.
inline Scene two_spheres() {
    Scene scene = scene_of({{{0, 0, 200}, 40, red, false}, {{40, 0, 150}, 30, blue, false}});
    return scene;
}

inline Edit change(std::uint32_t number, const Sphere& sphere) { return ChangeSpheres{{number}, {sphere}}; }

using Rgba = std::array<int, 4>;

inline Rgba at(const Image& image, int x, int y) {
    const std::uint8_t* p = image.at(x, y);
    return {p[0], p[1], p[2], p[3]};
}

inline Rgba opaque(Color color) { return {color.r, color.g, color.b, 255}; }

inline bool same(const Image& a, const Image& b) {
    return a.width() == b.width() && a.height() == b.height() && std::ranges::equal(a.bytes(), b.bytes());
}

// A framebuffer that stands for a window's, and what is in it.
class WindowTarget {
public:
    WindowTarget(int width, int height)
        : width_(width), height_(height), texture_(Texture::make()), framebuffer_(Framebuffer::make()) {
        glBindTexture(GL_TEXTURE_2D, texture_.name());
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
        bind();
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_.name(), 0);
        clear();
    }

    void bind() const { glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name()); }

    // To a colour that nothing in a test has.
    void clear() const {
        bind();
        glDisable(GL_SCISSOR_TEST);
        glClearColor(17.0F / 255.0F, 34.0F / 255.0F, 51.0F / 255.0F, 1.0F);
        glClear(GL_COLOR_BUFFER_BIT);
    }

    // RGBA, the top row first.
    Image pixels() const {
        bind();
        Image upside_down(width_, height_, 4);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, upside_down.bytes().data());
        Image picture(width_, height_, 4);
        for (int y = 0; y < height_; ++y) {
            const std::uint8_t* row = upside_down.at(0, height_ - 1 - y);
            std::copy(row, row + std::size_t{4} * static_cast<std::size_t>(width_), picture.at(0, y));
        }
        return picture;
    }

private:
    int width_;
    int height_;
    Texture texture_;
    Framebuffer framebuffer_;
};

// The whole window when the picture is drawn into it.
inline Image drawn_into_window(LivePicture& picture, const Document& document, const View& view, const Highlights& highlights) {
    const WindowTarget window(view.size.width, view.size.height);
    picture.show({0, 0, view.size.width, view.size.height}, document.scene().background, highlights);
    return window.pixels();
}

// What it shows after an update, which must trace.
inline Image shown(LivePicture& picture, const Document& document, const View& view, int step = 1,
                   const Highlights& highlights = {}) {
    EXPECT_TRUE(picture.update(document, view, step));
    return drawn_into_window(picture, document, view, highlights);
}

// As shown(), when there is nothing to trace.
inline Image shown_again(LivePicture& picture, const Document& document, const View& view, const Highlights& highlights = {}) {
    EXPECT_FALSE(picture.update(document, view, 1));
    return drawn_into_window(picture, document, view, highlights);
}

}  // namespace sphereview::test
