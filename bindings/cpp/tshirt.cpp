// tshirt.cpp [DESIGN [SIZE [SPACING_MM]]]: dress a body of a table size and print the hash of the state.
//
//     c++ -std=c++17 tshirt.cpp $(pkg-config --cflags --libs muslin) -o tshirt
//     ./tshirt skirt M50 20
#include <cinttypes>
#include <cstdio>
#include <cstdlib>

#include <muslin/muslin.hpp>

int main(int argc, char **argv)
try {
    const char *design = argc > 1 ? argv[1] : "tshirt";
    const char *size = argc > 2 ? argv[2] : "W40";
    auto options = muslin::defaults(mus_dress_def_init);
    if (argc > 3) options.spacing = 0.001 * std::atof(argv[3]);

    muslin::Context context;
    muslin::Tape tape(context, size);
    muslin::Body body(tape);
    auto pattern = muslin::Pattern::design(design, tape);
    muslin::Dressed dressed = muslin::dress(pattern, body, options);

    mus_drape_report report = dressed.drape.report();
    std::fprintf(stderr, "%s: %d of %d seams closed\n", design, report.seams_closed, report.seams);
    std::printf("%016" PRIx64 "\n", dressed.drape.hash());
    return 0;
} catch (const muslin::Error &error) {
    std::fprintf(stderr, "tshirt: %s\n", error.what());
    return 1;
}
