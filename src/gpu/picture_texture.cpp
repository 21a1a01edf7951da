#include "gpu/picture_texture.hpp"

namespace sphereview {

void upload(const Image& picture, Texture& texture) {
    if (!texture) texture = Texture::make();
    const bool transparent = picture.channels() == 4;
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, transparent ? GL_RGBA8 : GL_RGB8, picture.width(), picture.height(), 0,
                 transparent ? GL_RGBA : GL_RGB, GL_UNSIGNED_BYTE, picture.bytes().data());
    read_single_texels();
    check_gl("uploading a finished picture");
}

}  // namespace sphereview
