//! muslin: from a tape measure to a sewn and draped garment.
//!
//! ```no_run
//! use muslin::{dress, Body, Context, DressOptions, Pattern, Tape};
//! let context = Context::new()?;
//! let tape = Tape::of_size(&context, "W40")?;
//! let body = Body::new(&tape)?;
//! let pattern = Pattern::design("tshirt", &tape)?;
//! let dressed = dress(&pattern, &body, &DressOptions { spacing: 0.02, ..Default::default() }, |_| false)?;
//! println!("{} numbers", dressed.drape.positions().len());
//! # Ok::<(), muslin::Error>(())
//! ```
//!
//! Lengths are metres. Objects keep their [`Context`] alive and are neither `Send` nor `Sync`: a context, and all made
//! from it, stay on one thread. What is not wrapped here is called through [`sys`] with `as_ptr()` and
//! [`Context::check`].
use std::{
    any::Any,
    ffi::{c_void, CStr, CString},
    fmt,
    marker::PhantomData,
    panic::{catch_unwind, resume_unwind, AssertUnwindSafe},
    ptr::{null, null_mut, NonNull},
    rc::Rc,
    slice,
};

pub use muslin_sys as sys;

/// A call that failed: its status (`sys::MUS_ERR_*`) and the library's sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    pub status: i32,
    pub text: String,
}

impl Error {
    /// "MUS_ERR_TAPE"
    pub fn name(&self) -> String {
        unsafe { text(sys::mus_status_name(self.status)) }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.name(), self.text)
    }
}

impl std::error::Error for Error {}

pub type Result<T> = std::result::Result<T, Error>;

unsafe fn text(from: *const std::os::raw::c_char) -> String {
    if from.is_null() {
        return String::new();
    }
    CStr::from_ptr(from).to_string_lossy().into_owned()
}

fn c_text(from: &str) -> Result<CString> {
    CString::new(from).map_err(|_| Error { status: sys::MUS_ERR_ARG, text: format!("{from:?} holds a NUL byte") })
}

/// A struct of options or a report with its defaults and its size.
macro_rules! defaults {
    ($kind:ident, $init:ident) => {
        unsafe {
            let mut made: sys::$kind = std::mem::zeroed();
            sys::$init(&mut made, std::mem::size_of::<sys::$kind>());
            made
        }
    };
}

struct OwnedContext(NonNull<sys::mus_context>);

impl Drop for OwnedContext {
    fn drop(&mut self) {
        unsafe { sys::mus_context_destroy(self.0.as_ptr()) }
    }
}

/// What all objects are made from. A clone is the same context.
#[derive(Clone)]
pub struct Context(Rc<OwnedContext>);

impl Context {
    pub fn new() -> Result<Context> {
        let mut made = null_mut();
        let status = unsafe { sys::mus_context_create(null(), &mut made) };
        match NonNull::new(made) {
            Some(context) => Ok(Context(Rc::new(OwnedContext(context)))),
            None => Err(Error { status, text: unsafe { text(sys::mus_status_text(status)) } }),
        }
    }

    pub fn as_ptr(&self) -> *mut sys::mus_context {
        self.0 .0.as_ptr()
    }

    /// The status of a call of [`sys`] as a result.
    pub fn check(&self, status: sys::mus_status) -> Result<()> {
        if status == sys::MUS_OK {
            return Ok(());
        }
        let said = unsafe { text(sys::mus_context_error(self.as_ptr())) };
        let text = if said.is_empty() { unsafe { text(sys::mus_status_text(status)) } } else { said };
        Err(Error { status, text })
    }

    /// Bytes that the objects of this context hold.
    pub fn bytes(&self) -> usize {
        unsafe { sys::mus_context_bytes(self.as_ptr()) }
    }
}

macro_rules! handle {
    ($(#[$about:meta])* $name:ident, $kind:ident, $destroy:ident) => {
        $(#[$about])*
        pub struct $name {
            object: NonNull<sys::$kind>,
            context: Context,
        }

        impl $name {
            /// Owns the object that `create` gives through its pointer.
            fn make(context: &Context, create: impl FnOnce(*mut *mut sys::$kind) -> sys::mus_status) -> Result<$name> {
                let mut made = null_mut();
                let status = create(&mut made);
                let owned = NonNull::new(made).map(|object| $name { object, context: context.clone() });
                context.check(status)?;
                Ok(owned.expect("a call that succeeds gives an object"))
            }

            pub fn as_ptr(&self) -> *mut sys::$kind {
                self.object.as_ptr()
            }

            pub fn context(&self) -> &Context {
                &self.context
            }
        }

        impl Drop for $name {
            fn drop(&mut self) {
                unsafe { sys::$destroy(self.as_ptr()) }
            }
        }
    };
}

handle!(/** Measures of a person. */ Tape, mus_tape, mus_tape_destroy);
handle!(/** A body and its surface. */ Body, mus_body, mus_body_destroy);
handle!(/** Panels and seams. */ Pattern, mus_pattern, mus_pattern_destroy);
handle!(/** A pattern cut to a mesh. */ Cloth, mus_cloth, mus_cloth_destroy);
handle!(/** A cloth in motion round a body. */ Drape, mus_drape, mus_drape_destroy);

impl Tape {
    /// An empty tape.
    pub fn new(context: &Context) -> Result<Tape> {
        Tape::make(context, |out| unsafe { sys::mus_tape_create(context.as_ptr(), out) })
    }

    /// A complete tape of a table size: "W40".
    pub fn of_size(context: &Context, size: &str) -> Result<Tape> {
        let mut tape = Tape::new(context)?;
        let size = c_text(size)?;
        context.check(unsafe { sys::mus_tape_set_size(tape.as_ptr(), size.as_ptr()) })?;
        tape.complete()?;
        Ok(tape)
    }

    #[cfg(feature = "exchange")]
    pub fn read(context: &Context, path: &str) -> Result<Tape> {
        let path = c_text(path)?;
        Tape::make(context, |out| unsafe { sys::mus_tape_read(context.as_ptr(), path.as_ptr(), null(), out) })
    }

    /// Set a measure by its name: `tape.set("bust", 0.92)`.
    pub fn set(&mut self, measure: &str, value: f64) -> Result<()> {
        let name = c_text(measure)?;
        let set = |measure| unsafe { sys::mus_tape_set(self.as_ptr(), measure, value, sys::MUS_SOURCE_GIVEN) };
        self.context.check(set(unsafe { sys::mus_measure_find(name.as_ptr()) }))
    }

    /// A measure, NaN where the tape has none.
    pub fn get(&self, measure: &str) -> f64 {
        c_text(measure).map_or(f64::NAN, |name| unsafe {
            sys::mus_tape_value(self.as_ptr(), sys::mus_measure_find(name.as_ptr()))
        })
    }

    /// Derive the measures that were not given.
    pub fn complete(&mut self) -> Result<()> {
        self.context.check(unsafe { sys::mus_tape_complete(self.as_ptr()) })
    }
}

impl Body {
    pub fn new(tape: &Tape) -> Result<Body> {
        let context = tape.context();
        Body::make(context, |out| unsafe { sys::mus_body_create(context.as_ptr(), tape.as_ptr(), null(), out) })
    }

    /// x, y, z of each vertex.
    pub fn vertices(&self) -> &[f64] {
        unsafe { numbers(sys::mus_body_vertices(self.as_ptr()), 3 * sys::mus_body_vertex_count(self.as_ptr())) }
    }

    pub fn triangles(&self) -> &[i32] {
        unsafe { numbers(sys::mus_body_triangles(self.as_ptr()), 3 * sys::mus_body_triangle_count(self.as_ptr())) }
    }
}

unsafe fn numbers<'a, T>(data: *const T, count: i32) -> &'a [T] {
    if data.is_null() {
        &[]
    } else {
        slice::from_raw_parts(data, count as usize)
    }
}

impl Pattern {
    /// A named design, drafted for a tape.
    pub fn design(name: &str, tape: &Tape) -> Result<Pattern> {
        let (name, context) = (c_text(name)?, tape.context());
        Pattern::make(context, |out| unsafe {
            sys::mus_design_draft(context.as_ptr(), sys::mus_design_find(name.as_ptr()), tape.as_ptr(), null(), out)
        })
    }

    /// A garment in words, "dress neck=v", drafted for a tape.
    pub fn words(words: &str, tape: &Tape) -> Result<Pattern> {
        let (words, context) = (c_text(words)?, tape.context());
        Pattern::make(context, |out| unsafe {
            sys::mus_design_draft_words(context.as_ptr(), words.as_ptr(), tape.as_ptr(), null(), out)
        })
    }

    #[cfg(feature = "exchange")]
    pub fn read(context: &Context, path: &str) -> Result<Pattern> {
        let path = c_text(path)?;
        Pattern::make(context, |out| unsafe { sys::mus_pattern_read(context.as_ptr(), path.as_ptr(), out) })
    }
}

impl Cloth {
    pub fn triangles(&self) -> &[i32] {
        unsafe { numbers(sys::mus_cloth_triangles(self.as_ptr()), 3 * sys::mus_cloth_triangle_count(self.as_ptr())) }
    }
}

impl Drape {
    /// x, y, z of each node.
    pub fn positions(&self) -> &[f64] {
        unsafe { numbers(sys::mus_drape_positions(self.as_ptr()), 3 * sys::mus_drape_node_count(self.as_ptr())) }
    }

    /// Hash of the state: the same bits, the same hash.
    pub fn hash(&self) -> u64 {
        unsafe { sys::mus_drape_hash(self.as_ptr()) }
    }

    pub fn report(&self) -> Result<sys::mus_drape_report> {
        let mut report = defaults!(mus_drape_report, mus_drape_report_init);
        self.context.check(unsafe { sys::mus_drape_report_get(self.as_ptr(), &mut report) })?;
        Ok(report)
    }

    pub fn step(&mut self, steps: i32, dt: f64) -> Result<()> {
        self.context.check(unsafe { sys::mus_drape_step(self.as_ptr(), steps, dt) })
    }
}

/// The properties of a fabric: plain numbers.
pub type Fabric = sys::mus_fabric;

/// A fabric of the library by its name: "denim".
pub fn fabric(name: &str) -> Result<Fabric> {
    let (name, mut made) = (c_text(name)?, defaults!(mus_fabric, mus_fabric_init));
    match unsafe { sys::mus_fabric_find(name.as_ptr(), &mut made) } {
        sys::MUS_OK => Ok(made),
        status => Err(Error { status, text: format!("{name:?} is no fabric of the library") }),
    }
}

/// Options of [`dress`], as `mus_dress_def` has them; `place` and the options of the drape are left at their defaults.
#[derive(Clone, Copy)]
pub struct DressOptions {
    pub spacing: f64,
    pub fabric: Option<Fabric>,
    pub self_contact: bool,
    pub precision: i32,
    pub threads: i32,
    pub friction: f64,
    pub retry: bool,
    pub open_closures: bool,
    /// A pattern that takes more nodes is refused: set it before reading what strangers send.
    pub nodes_most: i32,
    pub progress_seconds: f64,
    /// Wall time that the run may take [s]; over it the run ends with `ERR_STOPPED`. 0: no limit.
    pub seconds_most: f64,
}

impl Default for DressOptions {
    fn default() -> Self {
        let def = defaults!(mus_dress_def, mus_dress_def_init);
        DressOptions {
            spacing: def.spacing,
            fabric: None,
            self_contact: def.self_contact != 0,
            precision: def.precision,
            threads: def.threads,
            friction: def.friction,
            retry: def.retry != 0,
            open_closures: def.open_closures != 0,
            nodes_most: def.nodes_most,
            progress_seconds: def.progress_seconds,
            seconds_most: def.seconds_most,
        }
    }
}

/// How far a run is: what the library tells a progress function, as long as that function runs.
pub struct Progress<'a>(sys::mus_progress, PhantomData<&'a ()>);

impl Progress<'_> {
    /// "sew", "settle"
    pub fn phase(&self) -> String {
        unsafe { text(self.0.phase) }
    }

    /// 0 to 1 of the phase.
    pub fn share(&self) -> f64 {
        self.0.progress
    }

    /// x, y, z of each node of the cut that moves.
    pub fn positions(&self) -> &[f64] {
        unsafe { numbers(self.0.positions, 3 * self.0.nodes) }
    }
}

struct Hook<F> {
    function: F,
    panic: Option<Box<dyn Any + Send>>,
}

unsafe extern "C" fn forward<F: FnMut(&Progress) -> bool>(user: *mut c_void, at: *const sys::mus_progress) -> i32 {
    let hook = &mut *(user as *mut Hook<F>);
    match catch_unwind(AssertUnwindSafe(|| (hook.function)(&Progress(*at, PhantomData)))) {
        Ok(stop) => i32::from(stop),
        Err(panic) => {
            hook.panic = Some(panic);
            1
        }
    }
}

/// A garment at rest on a body.
pub struct Dressed {
    pub cloth: Cloth,
    pub drape: Drape,
}

/// Place, cut, sew and settle. `progress` is told of the run, and returns true to stop it.
pub fn dress<F>(pattern: &Pattern, body: &Body, options: &DressOptions, progress: F) -> Result<Dressed>
where
    F: FnMut(&Progress) -> bool,
{
    let context = pattern.context();
    let mut hook = Hook { function: progress, panic: None };
    let mut def = defaults!(mus_dress_def, mus_dress_def_init);
    def.spacing = options.spacing;
    def.fabric = options.fabric.as_ref().map_or(null(), |fabric| fabric);
    def.self_contact = options.self_contact.into();
    def.precision = options.precision;
    def.threads = options.threads;
    def.friction = options.friction;
    def.retry = options.retry.into();
    def.open_closures = options.open_closures.into();
    def.nodes_most = options.nodes_most;
    def.progress_seconds = options.progress_seconds;
    def.seconds_most = options.seconds_most;
    def.progress = Some(forward::<F>);
    def.progress_user = &mut hook as *mut Hook<F> as *mut c_void;

    let mut cloth = None;
    let drape = Drape::make(context, |drape| {
        let mut status = sys::MUS_OK;
        cloth = Some(Cloth::make(context, |cloth| {
            status = unsafe {
                sys::mus_dress(
                    context.as_ptr(),
                    pattern.as_ptr(),
                    body.as_ptr(),
                    &def,
                    null_mut(),
                    null_mut(),
                    cloth,
                    drape,
                )
            };
            status
        }));
        status
    });
    if let Some(panic) = hook.panic {
        resume_unwind(panic);
    }
    Ok(Dressed { drape: drape?, cloth: cloth.expect("the call was made")? })
}
