//! tshirt [DESIGN [SIZE [SPACING_MM]]]: dress a body of a table size and print the hash of the state.
//!
//!     cargo run --example tshirt -- skirt M50 20
use muslin::{dress, Body, Context, DressOptions, Pattern, Tape};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let argument = |i: usize, otherwise| arguments.get(i).map_or(otherwise, String::as_str);
    let design = argument(0, "tshirt");
    let options = DressOptions { spacing: 0.001 * argument(2, "10").parse::<f64>()?, ..Default::default() };

    let context = Context::new()?;
    let tape = Tape::of_size(&context, argument(1, "W40"))?;
    let body = Body::new(&tape)?;
    let pattern = Pattern::design(design, &tape)?;
    let dressed = dress(&pattern, &body, &options, |_| false)?;

    let report = dressed.drape.report()?;
    eprintln!("{design}: {} of {} seams closed", report.seams_closed, report.seams);
    println!("{:016x}", dressed.drape.hash());
    Ok(())
}
