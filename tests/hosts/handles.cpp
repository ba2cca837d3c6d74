// handles.cpp: the handles of muslin.hpp move and never leak, failures are thrown, a callback may throw. Prints the
// hash of a dressed skirt at 30 mm. Built with the address sanitizer, which sees what is freed twice or never.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include <muslin/muslin.hpp>

#define FAIL(text) (std::fprintf(stderr, "%s:%d: %s\n", __FILE__, __LINE__, text), std::exit(1))
#define CHECK(x) ((x) ? void(0) : FAIL(#x))

template <typename H> constexpr bool moves_only()
{
    return std::is_nothrow_move_constructible_v<H> && std::is_nothrow_move_assignable_v<H> &&
           !std::is_copy_constructible_v<H> && !std::is_copy_assignable_v<H>;
}
static_assert(moves_only<muslin::Tape>() && moves_only<muslin::Body>() && moves_only<muslin::Pattern>());
static_assert(moves_only<muslin::Cloth>() && moves_only<muslin::Drape>() && moves_only<muslin::Fit>());
static_assert(moves_only<muslin::Move>() && moves_only<muslin::Faults>() && moves_only<muslin::Dressed>());

// the sentence and the status of a failure come through
static void test_errors(const muslin::Context &context)
{
    muslin::Tape tape(context);
    try {
        tape.set("waist", 7.8);
        tape.complete();
        FAIL("780 cm of waist were taken");
    } catch (const muslin::Error &error) {
        CHECK(error.status() == MUS_ERR_TAPE && std::strcmp(error.name(), "MUS_ERR_TAPE") == 0);
        CHECK(std::strstr(error.what(), "780.0 cm") != nullptr);
    }
    try {
        muslin::Pattern::words("dress neck=nonsense", tape);
        FAIL("nonsense was drafted");
    } catch (const std::runtime_error &error) {
        CHECK(std::strstr(error.what(), "MUS_ERR_") != nullptr);
    }
}

// an object may be moved, be assigned over, and outlive the name of its context
static muslin::Body moved(const char *size)
{
    muslin::Context context;
    muslin::Tape tape(context, size), other(context);
    other = std::move(tape);
    muslin::Tape last(std::move(other));
    CHECK(last["bust"] > 0.5);
    muslin::Body body(last), second(last);
    second = std::move(body);
    return second.posed(muslin::defaults(mus_pose_init));
}

// what a callback throws stops the run and arrives at the caller
static void test_callback(const muslin::Pattern &pattern, const muslin::Body &body, mus_dress_def options)
{
    options.progress_seconds = 1e-6;
    try {
        muslin::dress(pattern, body, options, [](const mus_progress &) -> bool { throw std::out_of_range("mine"); });
        FAIL("the callback's exception was lost");
    } catch (const std::out_of_range &error) {
        CHECK(std::strcmp(error.what(), "mine") == 0);
    }
    try {
        muslin::dress(pattern, body, options, [](const mus_progress &) { return true; });
        FAIL("the run was not stopped");
    } catch (const muslin::Error &error) {
        CHECK(error.status() == MUS_ERR_STOPPED);
    }
}

int main()
try {
    muslin::Context context;
    test_errors(context);
    CHECK(mus_context_bytes(context) == 0);
    CHECK(moved("W40").vertices().size() > 1000);
    {
        muslin::Tape tape(context, "W40");
        muslin::Body body(tape);
        auto pattern = muslin::Pattern::design("skirt", tape);
        auto options = muslin::defaults(mus_dress_def_init);
        options.spacing = 0.03;
        test_callback(pattern, body, options);
        muslin::Dressed dressed = muslin::dress(pattern, body, options);
        muslin::Fit fit(dressed.drape, body);
        CHECK(mus_fit_level_count(fit) > 0);
        CHECK(dressed.drape.positions().size() == 3 * std::size_t(mus_cloth_node_count(dressed.cloth)));

        muslin::Cloth cloth(pattern);
        muslin::Drape drape(cloth, body);
        drape.place();
        drape.check(mus_drape_pin(drape, 0, 1));
        drape.step(2, 0.5 * mus_drape_step_bound(drape));
        CHECK(context.make<muslin::Move>(mus_body_move, body, "walk", 0.0));
        std::printf("%016" PRIx64 "\n", dressed.drape.hash());
    }
    CHECK(mus_context_bytes(context) == 0);
    return 0;
} catch (const std::exception &error) {
    std::fprintf(stderr, "handles: %s\n", error.what());
    return 1;
}
