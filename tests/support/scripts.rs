//! The gnuplot scripts of `plot/`, run on what the program wrote, and their pictures read back.
#![allow(dead_code)] // each test file uses its own part

use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use tempfile::TempDir;

/// Twenty moving discs.
pub const MOVING: &str = "-n 20 --time 0.02 --seed 1 -q --speed 0.5 --radius 5e-4";

pub fn simulator(folder: &TempDir, arguments: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_parsim2d"));
    command.args(arguments.split_whitespace()).current_dir(folder);
    command
}

pub fn simulate_in(folder: &TempDir, arguments: &str) {
    let output = start(simulator(folder, arguments)).finish();
    assert!(output.status.success(), "{}", said(&output));
}

/// A folder with the files of a run.
pub fn simulate(arguments: &str) -> TempDir {
    let folder = TempDir::new().unwrap();
    simulate_in(&folder, arguments);
    folder
}

/// gnuplot on a script of `plot/`, without the settings of whoever runs the test.
pub fn gnuplot(folder: &TempDir, script: &str, variables: &str) -> Command {
    let scripts = Path::new(env!("CARGO_MANIFEST_DIR")).join("plot");
    let mut command = Command::new("gnuplot");
    command.args(["-d", "-e", variables]);
    command.arg(scripts.join(script).with_extension("plot"));
    command.current_dir(folder);
    command
}

/// Runs a script to its end, which must be a good one.
pub fn plot(folder: &TempDir, script: &str, variables: &str) -> Output {
    let output = start(gnuplot(folder, script, variables)).finish();
    assert!(output.status.success(), "{script}: {}", said(&output));
    output
}

pub fn said(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// A child process that does not outlive its test.
pub struct Running(pub Child);

pub fn start(mut command: Command) -> Running {
    command.stdin(Stdio::null());
    command.stdout(Stdio::null()).stderr(Stdio::piped());
    Running(command.spawn().unwrap())
}

impl Running {
    /// Waits for the end; the little that our programs say on stderr fits into a pipe.
    pub fn finish(mut self) -> Output {
        let status = wait_for("the end of a program", || self.0.try_wait().unwrap());
        let mut stderr = Vec::new();
        let mut pipe = self.0.stderr.take().unwrap();
        std::io::Read::read_to_end(&mut pipe, &mut stderr).unwrap();
        Output { status, stdout: Vec::new(), stderr }
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        let _ = self.0.kill(); // it may have ended
        let _ = self.0.wait();
    }
}

pub fn wait_for<T>(what: &str, mut look: impl FnMut() -> Option<T>) -> T {
    let began = Instant::now();
    loop {
        if let Some(found) = look() {
            return found;
        }
        assert!(began.elapsed() < Duration::from_secs(30), "waited too long for {what}");
        sleep(Duration::from_millis(10));
    }
}

/// A PNG, read back.
pub struct Picture {
    pub width: usize,
    pub height: usize,
    pub pixels: Vec<[u8; 3]>,
}

/// A disc, an arrow or a curve.
pub fn in_colour(pixel: [u8; 3]) -> bool {
    pixel.iter().max().unwrap() - pixel.iter().min().unwrap() > 40
}

/// A disc of the velocity plot.
pub fn light_grey(pixel: [u8; 3]) -> bool {
    pixel.iter().all(|channel| (0xE3..=0xE7).contains(channel))
}

impl Picture {
    pub fn read(folder: &TempDir, name: &str) -> Self {
        let path: PathBuf = folder.path().join(name);
        let file = std::io::BufReader::new(File::open(path).unwrap());
        let mut decoder = png::Decoder::new(file);
        decoder.set_transformations(png::Transformations::normalize_to_color8());
        let mut reader = decoder.read_info().unwrap();
        let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut bytes).unwrap();
        let pixels = bytes.chunks_exact(info.color_type.samples());
        Self {
            width: info.width as usize,
            height: info.height as usize,
            pixels: pixels.map(|pixel| [pixel[0], pixel[1], pixel[2]]).collect(),
        }
    }

    pub fn count(&self, wanted: impl Fn([u8; 3]) -> bool) -> usize {
        self.pixels.iter().filter(|pixel| wanted(**pixel)).count()
    }

    /// Columns and rows of the wanted pixels inside the box, where only discs and arrows are.
    pub fn places(&self, wanted: impl Fn([u8; 3]) -> bool) -> Vec<(usize, usize)> {
        let [left, right, top, bottom] = self.walls();
        let rows = (top + 3)..(bottom - 2); // a line may be two pixels wide
        rows.flat_map(|y| ((left + 3)..(right - 2)).map(move |x| (x, y)))
            .filter(|(x, y)| wanted(self.pixels[y * self.width + x]))
            .collect()
    }

    /// Left, right, top and bottom of the wanted pixels inside the box.
    pub fn bounds(&self, wanted: impl Fn([u8; 3]) -> bool) -> [usize; 4] {
        let start = [usize::MAX, 0, usize::MAX, 0];
        let places = self.places(wanted).into_iter();
        places.fold(start, |[l, r, t, b], (x, y)| [l.min(x), r.max(x), t.min(y), b.max(y)])
    }

    /// Columns of the left and right wall, rows of the upper and lower one: the second and third
    /// long dark line, after the frame of the axes.
    pub fn walls(&self) -> [usize; 4] {
        let (mut columns, mut rows) = (vec![0; self.width], vec![0; self.height]);
        for (index, pixel) in self.pixels.iter().enumerate() {
            if pixel.iter().all(|channel| *channel < 150) {
                columns[index % self.width] += 1;
                rows[index / self.width] += 1;
            }
        }
        let [[left, right], [top, bottom]] = [columns, rows].map(|dark| {
            let long = |k: usize| dark[k] > self.height / 2;
            let mut lines = (1..dark.len()).filter(|&k| long(k) && !long(k - 1));
            [1, 0].map(|skip| lines.nth(skip).expect("a wall"))
        });
        [left, right, top, bottom]
    }
}
