// hello.cpp: examples/hello.c as a C++ program writes it, with the handles of muslin.hpp.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "muslin/muslin.hpp"

static std::uint64_t drape(const char *tape_path, const char *pattern_path, double spacing)
{
    muslin::Context context;
    auto tape = muslin::Tape::read(context, tape_path);
    muslin::Body body(tape);
    auto pattern = muslin::Pattern::read(context, pattern_path);

    auto cut = muslin::defaults(mus_cloth_def_init);
    if (spacing > 0) cut.spacing = spacing;
    muslin::Cloth cloth(pattern, &cut);
    muslin::Drape drape(cloth, body);
    drape.place();
    drape.sew();
    drape.settle();
    return drape.hash();
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
