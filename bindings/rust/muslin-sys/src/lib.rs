//! The C interface of muslin, declaration by declaration: what `build.rs` reads in `muslin_flat.h`. The contract of each
//! function stands in the C headers and in the manual. The features `print`, `exchange` and `catalogue` add those
//! libraries.
#![allow(non_camel_case_types)]

use std::os::raw::{c_char, c_void};

include!(concat!(env!("OUT_DIR"), "/ffi.rs"));
