//! tshirt_sys DESIGN SIZE SPACING_MM: the same as the crate muslin's example by the C interface alone.
use muslin_sys::*;
use std::{ffi::CString, mem::size_of, mem::MaybeUninit, ptr::null, ptr::null_mut};

fn main() {
    let arguments: Vec<CString> = std::env::args().skip(1).map(|text| CString::new(text).unwrap()).collect();
    let [design, size, spacing] = &arguments[..] else { panic!("tshirt_sys DESIGN SIZE SPACING_MM") };
    let (mut context, mut tape, mut body) = (null_mut(), null_mut(), null_mut());
    let (mut pattern, mut cloth, mut drape) = (null_mut(), null_mut(), null_mut());
    unsafe {
        let check = |status| assert_eq!(status, MUS_OK);
        check(mus_context_create(null(), &mut context));
        check(mus_tape_create(context, &mut tape));
        check(mus_tape_set_size(tape, size.as_ptr()));
        check(mus_tape_complete(tape));
        check(mus_body_create(context, tape, null(), &mut body));
        check(mus_design_draft(context, mus_design_find(design.as_ptr()), tape, null(), &mut pattern));
        let mut def = MaybeUninit::<mus_dress_def>::zeroed();
        mus_dress_def_init(def.as_mut_ptr(), size_of::<mus_dress_def>());
        let mut def = def.assume_init();
        def.spacing = 0.001 * spacing.to_str().unwrap().parse::<f64>().unwrap();
        check(mus_dress(context, pattern, body, &def, null_mut(), null_mut(), &mut cloth, &mut drape));
        println!("{:016x}", mus_drape_hash(drape));
        mus_drape_destroy(drape);
        mus_cloth_destroy(cloth);
        mus_pattern_destroy(pattern);
        mus_body_destroy(body);
        mus_tape_destroy(tape);
        mus_context_destroy(context);
    }
}
