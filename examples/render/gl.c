/*
 * gl.c: EGL without a window system, and the OpenGL function table.
 *
 * libEGL.so.1 is opened at run time. Three ways to a display are tried in turn: the surfaceless platform of Mesa
 * (needs no X and no device), each device of EGL_EXT_platform_device (drivers without Mesa), and the default
 * display. The first that gives an OpenGL 3.3 core context wins; if none does, the error sentence says what the last
 * attempt of each kind met. The library is never closed again: drivers do not survive that.
 */
#define _POSIX_C_SOURCE 200809L
#define EGL_NO_X11
#define EGL_EGL_PROTOTYPES 0

#include "gl.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EGL_LIST(X)                         \
    X(BindAPI, BINDAPI)                     \
    X(ChooseConfig, CHOOSECONFIG)           \
    X(CreateContext, CREATECONTEXT)         \
    X(DestroyContext, DESTROYCONTEXT)       \
    X(GetDisplay, GETDISPLAY)               \
    X(GetError, GETERROR)                   \
    X(GetProcAddress, GETPROCADDRESS)       \
    X(Initialize, INITIALIZE)               \
    X(MakeCurrent, MAKECURRENT)             \
    X(QueryString, QUERYSTRING)             \
    X(ReleaseThread, RELEASETHREAD)         \
    X(Terminate, TERMINATE)

struct render_egl {
    EGLDisplay display;
    EGLContext context;
    EGLint code;         /* EGL error of the last attempt, 0 if there was none */
    const char *attempt; /* what the last attempt was */
#define EGL_MEMBER(name, type) PFNEGL##type##PROC name;
    EGL_LIST(EGL_MEMBER)
#undef EGL_MEMBER
};


int render_fail(render_error *error, const char *format, ...)
{
    va_list args;

    va_start(args, format);
    vsnprintf(error->text, sizeof error->text, format, args);
    va_end(args);
    return -1;
}


/* a function's address from an object's: dlsym speaks of objects only */
static int egl_symbol(void *library, const char *name, void *function)
{
    void *address = dlsym(library, name);

    memcpy(function, &address, sizeof address);
    return address ? 0 : -1;
}


static int egl_library(render_egl *egl, render_error *error)
{
    void *library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_LOCAL);

    if (!library) return render_fail(error, "no picture: libEGL.so.1 cannot be loaded (install libegl1 and a driver)");
#define EGL_LOAD(name, type) \
    if (egl_symbol(library, "egl" #name, &egl->name)) return render_fail(error, "no picture: libEGL has no egl" #name);
    EGL_LIST(EGL_LOAD)
#undef EGL_LOAD
    return 0;
}


/* whole-word search in a list of extensions */
static int egl_has(const char *list, const char *name)
{
    size_t n = strlen(name);

    for (const char *at = list ? strstr(list, name) : NULL; at; at = strstr(at + n, name))
        if ((at == list || at[-1] == ' ') && (at[n] == ' ' || at[n] == '\0')) return 1;
    return 0;
}


/* an OpenGL 3.3 core context on `display`, made current without a surface; everything is undone on failure */
static int egl_try(render_egl *egl, EGLDisplay display, const char *attempt)
{
    static const EGLint config_attributes[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    static const EGLint context_attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                                                3,
                                                EGL_CONTEXT_MINOR_VERSION,
                                                3,
                                                EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                EGL_NONE};
    EGLConfig config = NULL;
    EGLint count = 0;

    egl->attempt = attempt;
    egl->code = 0;
    if (display == EGL_NO_DISPLAY || !egl->Initialize(display, NULL, NULL)) goto fail;
    if (!egl->BindAPI(EGL_OPENGL_API)) goto fail_display;
    if (!egl->ChooseConfig(display, config_attributes, &config, 1, &count) || count < 1) goto fail_display;

    egl->context = egl->CreateContext(display, config, EGL_NO_CONTEXT, context_attributes);
    if (egl->context == EGL_NO_CONTEXT) goto fail_display;
    if (egl->MakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, egl->context)) {
        egl->display = display;
        return 0;
    }
    egl->code = egl->GetError();
    egl->DestroyContext(display, egl->context);

fail_display:
    if (!egl->code) egl->code = egl->GetError();
    egl->Terminate(display);
fail:
    if (!egl->code) egl->code = egl->GetError();
    egl->context = EGL_NO_CONTEXT;
    return -1;
}


/* every device in turn */
static int egl_try_devices(render_egl *egl, PFNEGLGETPLATFORMDISPLAYEXTPROC platform_display)
{
    EGLDeviceEXT devices[16];
    EGLint count = 0;
    PFNEGLQUERYDEVICESEXTPROC query = (PFNEGLQUERYDEVICESEXTPROC)egl->GetProcAddress("eglQueryDevicesEXT");

    if (!query || !query(16, devices, &count)) return -1;
    for (EGLint i = 0; i < count; i++)
        if (!egl_try(egl, platform_display(EGL_PLATFORM_DEVICE_EXT, devices[i], NULL), "device platform")) return 0;
    return -1;
}


static int egl_display(render_egl *egl, render_error *error)
{
    const char *extensions = egl->QueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    PFNEGLGETPLATFORMDISPLAYEXTPROC platform_display =
        (PFNEGLGETPLATFORMDISPLAYEXTPROC)egl->GetProcAddress("eglGetPlatformDisplayEXT");

    egl->attempt = "default display";
    if (platform_display && egl_has(extensions, "EGL_MESA_platform_surfaceless")) {
        EGLDisplay display = platform_display(EGL_PLATFORM_SURFACELESS_MESA, NULL, NULL);
        if (!egl_try(egl, display, "surfaceless platform")) return 0;
    }
    if (platform_display && egl_has(extensions, "EGL_EXT_platform_device") && !egl_try_devices(egl, platform_display))
        return 0;
    if (!egl_try(egl, egl->GetDisplay(EGL_DEFAULT_DISPLAY), "default display")) return 0;
    return render_fail(error,
                       "no picture: libEGL.so.1 is there, but no display gives OpenGL 3.3 core (last tried: %s, EGL "
                       "error 0x%04x); a software driver is enough (Debian: libegl-mesa0 and libgl1-mesa-dri)",
                       egl->attempt, (unsigned)egl->code);
}


static int egl_functions(const render_egl *egl, render_gl *gl, render_error *error)
{
#define GL_LOAD(name, type)                                         \
    gl->name = (PFNGL##type##PROC)egl->GetProcAddress("gl" #name);  \
    if (!gl->name) return render_fail(error, "no picture: the OpenGL driver has no gl" #name);
    RENDER_GL_LIST(GL_LOAD)
#undef GL_LOAD
    return 0;
}


int render_egl_open(render_egl **out, render_gl *gl, render_error *error)
{
    render_egl *egl = calloc(1, sizeof *egl);

    *out = NULL;
    if (!egl) return render_fail(error, "no picture: out of memory");

    /* EGL would print warnings of its own beside our sentence */
    setenv("EGL_LOG_LEVEL", "fatal", 0);
    if (egl_library(egl, error) || egl_display(egl, error) || egl_functions(egl, gl, error)) {
        render_egl_close(egl);
        return -1;
    }
    *out = egl;
    return 0;
}


int render_egl_enter(render_egl *egl, render_error *error)
{
    if (egl->MakeCurrent(egl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, egl->context)) return 0;
    return render_fail(error, "no picture: the OpenGL context cannot be made current (EGL error 0x%04x)",
                       (unsigned)egl->GetError());
}


void render_egl_close(render_egl *egl)
{
    if (!egl) return;
    if (egl->context != EGL_NO_CONTEXT) {
        egl->MakeCurrent(egl->display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        egl->DestroyContext(egl->display, egl->context);
        egl->Terminate(egl->display);
        egl->ReleaseThread();
    }
    free(egl);
}
