// muslin.hpp: the C interface of muslin as C++17 handles. One header, no library of its own; a program links those of
// the four libraries whose functions it uses.
//
// Every object of the library is a move-only handle that destroys it and keeps its context alive. A call that fails
// throws muslin::Error with the status and the library's sentence. What is wrapped here is what most programs need; a
// handle converts to the pointer of the C interface, so that every other function takes it as it is:
//
//     drape.check(mus_drape_pin(drape, 7, 1));                     // throws where the status is not MUS_OK
//     auto move = body.make<muslin::Move>(mus_body_move, body, "walk", 0.0);
//
// One context, and all made from it, serve one thread at a time. Lengths are metres. The contract of each function
// stands in the C headers and in the manual.
#ifndef MUSLIN_HPP
#define MUSLIN_HPP

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "muslin/catalogue.h"
#include "muslin/exchange.h"
#include "muslin/muslin.h"
#include "muslin/print.h"

namespace muslin {

// A call that failed: what() is "MUS_ERR_TAPE: " and the library's sentence.
class Error : public std::runtime_error {
public:
    Error(mus_status status, const std::string &text)
        : std::runtime_error(std::string(mus_status_name(status)) + ": " + text), status_(status), text_(text)
    {
    }
    mus_status status() const noexcept { return status_; }
    const char *name() const noexcept { return mus_status_name(status_); }
    const std::string &text() const noexcept { return text_; } // the sentence alone

private:
    mus_status status_;
    std::string text_;
};

// Numbers that an object of the library owns: valid as long as the object, and not copied.
template <typename T> class View {
public:
    View(const T *data, std::size_t size) : data_(data), size_(size) {}
    const T *data() const noexcept { return data_; }
    std::size_t size() const noexcept { return size_; }
    const T *begin() const noexcept { return data_; }
    const T *end() const noexcept { return data_ + size_; }
    const T &operator[](std::size_t i) const noexcept { return data_[i]; }

private:
    const T *data_;
    std::size_t size_;
};

// Options or a report with the defaults and the size: auto options = muslin::defaults(mus_dress_def_init);
template <typename S> S defaults(void (*init)(S *, std::size_t))
{
    S made;
    init(&made, sizeof made);
    return made;
}

// Copies of a Context are the same context; the last of them, and of the objects made from it, frees it.
class Context {
public:
    explicit Context(const mus_context_def *def = nullptr)
    {
        mus_context *made = nullptr;
        mus_status status = mus_context_create(def, &made);
        if (status != MUS_OK) throw Error(status, mus_status_text(status));
        context_.reset(made, mus_context_destroy);
    }
    operator mus_context *() const noexcept { return context_.get(); }
    void check(mus_status status) const
    {
        if (status == MUS_OK) return;
        const char *text = mus_context_error(*this);
        throw Error(status, *text ? text : mus_status_text(status));
    }
    // An H from a function that gives it through its last argument: make<Tape>(mus_tape_create, context).
    template <typename H, typename F, typename... A> H make(F create, A &&...arguments) const;

private:
    std::shared_ptr<mus_context> context_;
};

// An object of the library: moved, never copied.
template <typename T, void (*destroy)(T *)> class Handle {
public:
    using type = T;
    explicit Handle(const Context &context, T *object = nullptr) noexcept : context_(context), object_(object) {}
    Handle(Handle &&from) noexcept : context_(from.context_), object_(std::exchange(from.object_, nullptr)) {}
    Handle &operator=(Handle &&from) noexcept
    {
        Handle taken(std::move(from));
        std::swap(context_, taken.context_);
        std::swap(object_, taken.object_);
        return *this;
    }
    ~Handle() { destroy(object_); }
    operator T *() noexcept { return object_; }
    operator const T *() const noexcept { return object_; }
    T **out() noexcept { return &object_; } // for a call that makes the object; the handle must be empty
    const Context &context() const noexcept { return context_; }
    void check(mus_status status) const { context_.check(status); }
    template <typename H, typename F, typename... A> H make(F create, A &&...arguments) const
    {
        return context_.make<H>(create, std::forward<A>(arguments)...);
    }

private:
    Context context_;
    T *object_;
};

template <typename H, typename F, typename... A> H Context::make(F create, A &&...arguments) const
{
    H handle(*this, static_cast<typename H::type *>(nullptr));
    check(create(std::forward<A>(arguments)..., handle.out()));
    return handle;
}

using Move = Handle<mus_move, mus_move_destroy>;
using Faults = Handle<mus_faults, mus_faults_destroy>;
using Sheet = Handle<mus_sheet, mus_sheet_destroy>;
using Mesh = Handle<mus_mesh, mus_mesh_destroy>;
using Catalogue = Handle<mus_catalogue, mus_catalogue_destroy>;

// A function as the library's progress function. What it throws stops the run and is thrown on by rethrow().
class Progress {
public:
    using Function = std::function<bool(const mus_progress &)>; // true: stop the run
    explicit Progress(Function function) : function_(std::move(function)) {}
    mus_progress_fn call() const noexcept { return function_ ? &Progress::forward : nullptr; }
    void rethrow()
    {
        if (raised_) std::rethrow_exception(std::exchange(raised_, nullptr));
    }

private:
    static std::int32_t forward(void *user, const mus_progress *progress) noexcept
    {
        auto *self = static_cast<Progress *>(user);
        try {
            return self->function_(*progress);
        } catch (...) {
            self->raised_ = std::current_exception();
            return 1;
        }
    }
    Function function_;
    std::exception_ptr raised_;
};

class Tape : public Handle<mus_tape, mus_tape_destroy> {
public:
    using Handle::Handle;
    explicit Tape(const Context &context) : Handle(context.make<Tape>(mus_tape_create, context)) {}
    Tape(const Context &context, const char *size) : Tape(context) // complete, of a table size: "W40"
    {
        check(mus_tape_set_size(*this, size));
        complete();
    }
    static Tape read(const Context &context, const char *path, const char *row = nullptr)
    {
        return context.make<Tape>(mus_tape_read, context, path, row);
    }
    void set(const char *measure, double value)
    {
        check(mus_tape_set(*this, mus_measure_find(measure), value, MUS_SOURCE_GIVEN));
    }
    double operator[](const char *measure) const { return mus_tape_value(*this, mus_measure_find(measure)); }
    void complete() { check(mus_tape_complete(*this)); }
};

class Body : public Handle<mus_body, mus_body_destroy> {
public:
    using Handle::Handle;
    explicit Body(const Tape &tape, const mus_body_def *def = nullptr)
        : Handle(tape.make<Body>(mus_body_create, tape.context(), tape, def))
    {
    }
    Body posed(const mus_pose &pose) const { return make<Body>(mus_body_pose, *this, &pose); }
    View<double> vertices() const { return {mus_body_vertices(*this), 3 * std::size_t(mus_body_vertex_count(*this))}; }
    View<std::int32_t> triangles() const
    {
        return {mus_body_triangles(*this), 3 * std::size_t(mus_body_triangle_count(*this))};
    }
};

class Pattern : public Handle<mus_pattern, mus_pattern_destroy> {
public:
    using Handle::Handle;
    Pattern(const Context &context, const char *name)
        : Handle(context.make<Pattern>(mus_pattern_create, context, name))
    {
    }
    // A named design, or a garment in words, drafted for a tape.
    static Pattern design(const char *name, const Tape &tape, const mus_draft_def *def = nullptr)
    {
        return tape.make<Pattern>(mus_design_draft, tape.context(), mus_design_find(name), tape, def);
    }
    static Pattern words(const char *words, const Tape &tape, const mus_draft_def *def = nullptr)
    {
        return tape.make<Pattern>(mus_design_draft_words, tape.context(), words, tape, def);
    }
    static Pattern read(const Context &context, const char *path)
    {
        return context.make<Pattern>(mus_pattern_read, context, path);
    }
    void write(const char *path) const { check(mus_pattern_write(*this, path)); }
};

class Cloth : public Handle<mus_cloth, mus_cloth_destroy> {
public:
    using Handle::Handle;
    explicit Cloth(const Pattern &pattern, const mus_cloth_def *def = nullptr)
        : Handle(pattern.make<Cloth>(mus_cloth_create, pattern.context(), pattern, def))
    {
    }
    View<std::int32_t> triangles() const
    {
        return {mus_cloth_triangles(*this), 3 * std::size_t(mus_cloth_triangle_count(*this))};
    }
};

class Drape : public Handle<mus_drape, mus_drape_destroy> {
public:
    using Handle::Handle;
    explicit Drape(const Cloth &cloth, const Body &body, const mus_drape_def *def = nullptr)
        : Handle(cloth.make<Drape>(mus_drape_create, cloth.context(), cloth, body, def))
    {
    }
    void place() { check(mus_drape_place(*this)); }
    void sew(Progress::Function progress = nullptr) { run(mus_drape_sew, std::move(progress)); }
    void settle(Progress::Function progress = nullptr) { run(mus_drape_settle, std::move(progress)); }
    void step(std::int32_t steps, double dt) { check(mus_drape_step(*this, steps, dt)); }
    View<double> positions() const
    {
        return {mus_drape_positions(*this), 3 * std::size_t(mus_drape_node_count(*this))};
    }
    std::uint64_t hash() const { return mus_drape_hash(*this); }
    mus_drape_report report() const
    {
        auto report = defaults(mus_drape_report_init);
        check(mus_drape_report_get(*this, &report));
        return report;
    }

private:
    template <typename F> void run(F function, Progress::Function progress)
    {
        Progress hook(std::move(progress));
        mus_status status = function(*this, hook.call(), &hook);
        hook.rethrow();
        check(status);
    }
};

class Fit : public Handle<mus_fit, mus_fit_destroy> {
public:
    using Handle::Handle;
    Fit(const Drape &drape, const Body &body) : Handle(drape.make<Fit>(mus_fit_create, drape, body)) {}
};

// The garment at rest on a body, and how it came on.
struct Dressed {
    Cloth cloth;
    Drape drape;
    mus_dress_report report;
};

inline Dressed dress(const Pattern &pattern, const Body &body, mus_dress_def options = defaults(mus_dress_def_init),
                     Progress::Function progress = nullptr)
{
    Progress hook(std::move(progress));
    if (hook.call()) {
        options.progress = hook.call();
        options.progress_user = &hook;
    }
    const Context &context = pattern.context();
    Dressed dressed{Cloth(context), Drape(context), defaults(mus_dress_report_init)};
    mus_status status = mus_dress(context, pattern, body, &options, &dressed.report, nullptr, dressed.cloth.out(),
                                  dressed.drape.out());
    hook.rethrow();
    context.check(status);
    return dressed;
}

} // namespace muslin

#endif
