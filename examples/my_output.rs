//! My own output: a file that gnuplot draws, written in a loop of my own, and the script beside it.
//!
//! `Simulation::step` is one time step and writes nothing, so a file is whatever is written between
//! steps. Here: how high the centre of mass of a falling heap is, against the parabola it would
//! follow without the floor, and the fastest speed.
//!
//! Run it: cargo run --example my_output          then: gnuplot -p heap.gp
use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::Path;

use parsim2d::scenario::Scenario;

const SCRIPT: &str = "\
set xlabel 'time, s' ; set ylabel 'height of the centre of mass, m'
set y2label 'fastest disc, m/s' ; set y2tics ; set ytics nomirror ; set key top center
plot 'heap.dat' using 1:2 with lines lw 2 title 'height', '' using 1:3 with lines dt 2 title 'free fall', \\
     '' using 1:4 axes x1y2 with lines title 'fastest'
";

/// Writes `heap.dat` and `heap.gp` into `folder`; returns the heights (m) at start and end.
pub fn write_heap(folder: &Path) -> io::Result<[f64; 2]> {
    let scenario = "n = 100\nseed = 1\nradius = 5e-4\nrestitution = 0.5";
    let mut simulation = Scenario::from_toml(scenario).unwrap().build().unwrap();
    let n = simulation.n() as f64;
    let mut out = BufWriter::new(File::create(folder.join("heap.dat"))?);
    writeln!(out, "# time_s height_m free_fall_m fastest_m_per_s")?;
    let start = simulation.sum_over(|disc| disc.position.y) / n;
    let mut height = start;
    while simulation.time() < 0.3 {
        height = simulation.sum_over(|disc| disc.position.y) / n;
        let fall = (start - 0.5 * 9.81 * simulation.time().powi(2)).max(0.0);
        let speeds = simulation.particles().iter().map(|disc| disc.velocity.length());
        let fastest = speeds.fold(0.0, f64::max);
        writeln!(out, "{:.6} {height:.9} {fall:.9} {fastest:.6}", simulation.time())?;
        simulation.step_until(simulation.steps() + 100); // a row every hundred steps
    }
    out.flush()?;
    std::fs::write(folder.join("heap.gp"), SCRIPT)?;
    Ok([start, height])
}

pub fn main() {
    let [start, end] = write_heap(Path::new(".")).unwrap();
    println!("the heap came down from {start:.4} m to {end:.4} m: gnuplot -p heap.gp");
    assert!(end < 0.5 * start, "it should have settled");
}
