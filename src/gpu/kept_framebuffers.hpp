// Restores the bound framebuffers.
#pragma once

#include "gpu/gl_object.hpp"

namespace sphereview {

// Keeps the bound framebuffers, and binds them again at its end.
class KeptFramebuffers {
public:
    KeptFramebuffers() : draw_(gl_limit(GL_DRAW_FRAMEBUFFER_BINDING)), read_(gl_limit(GL_READ_FRAMEBUFFER_BINDING)) {}
    ~KeptFramebuffers() {
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, draw());
        glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
    }
    KeptFramebuffers(const KeptFramebuffers&) = delete;
    KeptFramebuffers& operator=(const KeptFramebuffers&) = delete;

    GLuint draw() const { return static_cast<GLuint>(draw_); }

private:
    GLint draw_;
    GLint read_;
};

}  // namespace sphereview
