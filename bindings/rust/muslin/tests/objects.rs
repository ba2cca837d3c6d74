//! Failures are results, objects free what they own in any order, a closure stops a run and may panic.
use muslin::{dress, sys, Body, Context, DressOptions, Pattern, Tape};
use std::panic::{catch_unwind, AssertUnwindSafe};

#[test]
fn a_failure_is_a_result_with_the_sentence() {
    let context = Context::new().unwrap();
    let error = Tape::new(&context).unwrap().set("waist", 7.8).unwrap_err();
    assert_eq!(error.status, sys::MUS_ERR_TAPE);
    assert!(error.to_string().starts_with("MUS_ERR_TAPE: ") && error.text.contains("780.0 cm"));
    assert!(Pattern::design("nonsense", &Tape::of_size(&context, "W40").unwrap()).is_err());
    assert!(Tape::of_size(&context, "W\0").is_err() && muslin::fabric("nonsense").is_err());
    assert_eq!(context.bytes(), 0);
}

#[test]
fn an_object_outlives_the_name_of_its_context() {
    let tape = Tape::of_size(&Context::new().unwrap(), "W40").unwrap();
    let body = Body::new(&tape).unwrap();
    let context = tape.context().clone();
    drop(tape);
    assert!(body.vertices().len() > 1000 && context.bytes() > 0);
    drop(body);
    assert_eq!(context.bytes(), 0);
}

#[test]
fn a_closure_stops_a_run_and_its_panic_arrives() {
    let context = Context::new().unwrap();
    let tape = Tape::of_size(&context, "W40").unwrap();
    let (body, pattern) = (Body::new(&tape).unwrap(), Pattern::design("skirt", &tape).unwrap());
    let denim = muslin::fabric("denim").ok();
    let options = DressOptions { spacing: 0.04, fabric: denim, progress_seconds: 1e-6, ..Default::default() };
    let stopped = dress(&pattern, &body, &options, |at| at.share() >= 0.0 && !at.positions().is_empty());
    assert_eq!(stopped.err().unwrap().status, sys::MUS_ERR_STOPPED);
    let panic = catch_unwind(AssertUnwindSafe(|| dress(&pattern, &body, &options, |_| panic!("mine")).is_ok()));
    assert_eq!(panic.unwrap_err().downcast_ref::<&str>(), Some(&"mine"));
    drop((tape, body, pattern));
    assert_eq!(context.bytes(), 0);
}
