/*
 * gl.h: the OpenGL functions that the renderer calls, and the context that they work on.
 *
 * One list names them all; gl.c looks each up with eglGetProcAddress after dlopen of libEGL.so.1, so the program
 * starts, and can say what is missing, on a machine without EGL. Members carry the GL name without "gl".
 */
#ifndef RENDER_GL_H
#define RENDER_GL_H

#include "render.h"

#include <stddef.h>

#include <GL/glcorearb.h>

/* X(name, type): gl.name is glname of type PFNGL type PROC */
#define RENDER_GL_LIST(X)                               \
    X(ActiveTexture, ACTIVETEXTURE)                     \
    X(AttachShader, ATTACHSHADER)                       \
    X(BindAttribLocation, BINDATTRIBLOCATION)           \
    X(BindBuffer, BINDBUFFER)                           \
    X(BindFramebuffer, BINDFRAMEBUFFER)                 \
    X(BindRenderbuffer, BINDRENDERBUFFER)               \
    X(BindSampler, BINDSAMPLER)                         \
    X(BindTexture, BINDTEXTURE)                         \
    X(BindVertexArray, BINDVERTEXARRAY)                 \
    X(BlendFunc, BLENDFUNC)                             \
    X(BlitFramebuffer, BLITFRAMEBUFFER)                 \
    X(BufferData, BUFFERDATA)                           \
    X(CheckFramebufferStatus, CHECKFRAMEBUFFERSTATUS)   \
    X(Clear, CLEAR)                                     \
    X(CompileShader, COMPILESHADER)                     \
    X(CreateProgram, CREATEPROGRAM)                     \
    X(CreateShader, CREATESHADER)                       \
    X(DeleteBuffers, DELETEBUFFERS)                     \
    X(DeleteFramebuffers, DELETEFRAMEBUFFERS)           \
    X(DeleteProgram, DELETEPROGRAM)                     \
    X(DeleteRenderbuffers, DELETERENDERBUFFERS)         \
    X(DeleteSamplers, DELETESAMPLERS)                   \
    X(DeleteShader, DELETESHADER)                       \
    X(DeleteTextures, DELETETEXTURES)                   \
    X(DeleteVertexArrays, DELETEVERTEXARRAYS)           \
    X(DepthFunc, DEPTHFUNC)                             \
    X(DepthMask, DEPTHMASK)                             \
    X(Disable, DISABLE)                                 \
    X(DrawArrays, DRAWARRAYS)                           \
    X(DrawBuffer, DRAWBUFFER)                           \
    X(DrawElements, DRAWELEMENTS)                       \
    X(Enable, ENABLE)                                   \
    X(EnableVertexAttribArray, ENABLEVERTEXATTRIBARRAY) \
    X(FramebufferRenderbuffer, FRAMEBUFFERRENDERBUFFER) \
    X(FramebufferTexture2D, FRAMEBUFFERTEXTURE2D)       \
    X(GenBuffers, GENBUFFERS)                           \
    X(GenFramebuffers, GENFRAMEBUFFERS)                 \
    X(GenRenderbuffers, GENRENDERBUFFERS)               \
    X(GenSamplers, GENSAMPLERS)                         \
    X(GenTextures, GENTEXTURES)                         \
    X(GenVertexArrays, GENVERTEXARRAYS)                 \
    X(GenerateMipmap, GENERATEMIPMAP)                   \
    X(GetError, GETERROR)                               \
    X(GetIntegerv, GETINTEGERV)                         \
    X(GetProgramInfoLog, GETPROGRAMINFOLOG)             \
    X(GetProgramiv, GETPROGRAMIV)                       \
    X(GetShaderInfoLog, GETSHADERINFOLOG)               \
    X(GetShaderiv, GETSHADERIV)                         \
    X(GetString, GETSTRING)                             \
    X(GetUniformLocation, GETUNIFORMLOCATION)           \
    X(LinkProgram, LINKPROGRAM)                         \
    X(PixelStorei, PIXELSTOREI)                         \
    X(PolygonOffset, POLYGONOFFSET)                     \
    X(ReadBuffer, READBUFFER)                           \
    X(ReadPixels, READPIXELS)                           \
    X(RenderbufferStorageMultisample, RENDERBUFFERSTORAGEMULTISAMPLE) \
    X(SamplerParameteri, SAMPLERPARAMETERI)             \
    X(Scissor, SCISSOR)                                 \
    X(ShaderSource, SHADERSOURCE)                       \
    X(TexImage2D, TEXIMAGE2D)                           \
    X(TexParameterfv, TEXPARAMETERFV)                   \
    X(TexParameteri, TEXPARAMETERI)                     \
    X(Uniform1f, UNIFORM1F)                             \
    X(Uniform1i, UNIFORM1I)                             \
    X(Uniform2f, UNIFORM2F)                             \
    X(Uniform3f, UNIFORM3F)                             \
    X(UniformMatrix4fv, UNIFORMMATRIX4FV)               \
    X(UseProgram, USEPROGRAM)                           \
    X(VertexAttribPointer, VERTEXATTRIBPOINTER)         \
    X(Viewport, VIEWPORT)

typedef struct render_gl {
#define RENDER_GL_MEMBER(name, type) PFNGL##type##PROC name;
    RENDER_GL_LIST(RENDER_GL_MEMBER)
#undef RENDER_GL_MEMBER
} render_gl;

/* The display and context behind the functions; its inside is gl.c's. */
typedef struct render_egl render_egl;

/** Open EGL, make an OpenGL 3.3 core context current and fill `gl`. */
int render_egl_open(render_egl **out, render_gl *gl, render_error *error);

/** Make the context current on this thread, or leave it. */
int render_egl_enter(render_egl *egl, render_error *error);
void render_egl_close(render_egl *egl);

/** Put a formatted sentence into `error`; returns -1. */
int render_fail(render_error *error, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
