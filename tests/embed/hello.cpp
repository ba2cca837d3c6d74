// hello.cpp: examples/hello.c as a C++ program writes it: handles in unique_ptr, a status as an exception.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>

#include "muslin/exchange.h"
#include "muslin/muslin.h"

template <typename T, void (*destroy)(T *)> struct Destroy {
    void operator()(T *object) const { destroy(object); }
};
template <typename T, void (*destroy)(T *)> using Handle = std::unique_ptr<T, Destroy<T, destroy>>;

using Context = Handle<mus_context, mus_context_destroy>;
using Tape = Handle<mus_tape, mus_tape_destroy>;
using Body = Handle<mus_body, mus_body_destroy>;
using Pattern = Handle<mus_pattern, mus_pattern_destroy>;
using Cloth = Handle<mus_cloth, mus_cloth_destroy>;
using Drape = Handle<mus_drape, mus_drape_destroy>;

static void must(const Context &context, mus_status status)
{
    if (status != MUS_OK) throw std::runtime_error(mus_context_error(context.get()));
}

// an object by a function that gives it through its last argument
template <typename H, typename F> static H make(const Context &context, F create)
{
    typename H::pointer object = nullptr;
    must(context, create(&object));
    return H(object);
}

static std::uint64_t drape(const char *tape_path, const char *pattern_path, double spacing)
{
    auto context = make<Context>(Context(), [](mus_context **out) { return mus_context_create(nullptr, out); });
    mus_context *c = context.get();
    auto tape = make<Tape>(context, [&](mus_tape **out) { return mus_tape_read(c, tape_path, nullptr, out); });
    auto body = make<Body>(context, [&](mus_body **out) { return mus_body_create(c, tape.get(), nullptr, out); });
    auto pattern = make<Pattern>(context, [&](mus_pattern **out) { return mus_pattern_read(c, pattern_path, out); });

    mus_cloth_def cut;
    mus_cloth_def_init(&cut, sizeof cut);
    if (spacing > 0) cut.spacing = spacing;
    auto cloth = make<Cloth>(context, [&](mus_cloth **out) { return mus_cloth_create(c, pattern.get(), &cut, out); });
    auto drape = make<Drape>(context, [&](mus_drape **out) {
        return mus_drape_create(c, cloth.get(), body.get(), nullptr, out);
    });
    must(context, mus_drape_place(drape.get()));
    must(context, mus_drape_sew(drape.get(), nullptr, nullptr));
    must(context, mus_drape_settle(drape.get(), nullptr, nullptr));
    return mus_drape_hash(drape.get());
}

int main(int argc, char **argv)
{
    try {
        if (argc < 3) throw std::runtime_error("usage: hello TAPE PATTERN [SPACING_MM]");
        std::uint64_t hash = drape(argv[1], argv[2], argc > 3 ? 0.001 * std::atof(argv[3]) : 0);
        std::printf("%016llx\n", static_cast<unsigned long long>(hash));
        return 0;
    } catch (const std::exception &error) {
        std::fprintf(stderr, "hello: %s\n", error.what());
        return 1;
    }
}
