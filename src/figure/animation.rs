//! An animated GIF of all frames: discs to scale, coloured by speed, and a clock.

use std::fmt::Write as _;
use std::io::{self, Write};

use glam::DVec2;

use super::colour::{self, hex};
use super::frame;
use super::gnuplot::{self, DataFile};
use super::raster::{Canvas, HUES, palette};
use super::scene::View;
use super::survey::Survey;
use crate::number::seconds;
use crate::output::frames::Frame;

/// Colour of discs whose speeds are not known: blue of Okabe and Ito.
const PLAIN: [u8; 3] = [0x00, 0x72, 0xb2];
/// Room for the clock above the picture, pixels.
const CLOCK: usize = 20;

/// A GIF being written.
pub struct Animation<W: Write> {
    encoder: gif::Encoder<W>,
    canvas: Canvas,
    size: usize, // px
    delay: u16,  // 1/100 s
    survey: Survey,
    view: View,
}

/// Hundredths of a second between frames at so many a second; a GIF knows no shorter unit, and
/// below two of them browsers go slowly.
///
/// ```
/// assert_eq!(parsim2d::figure::animation::delay(20.0), 5);
/// ```
pub fn delay(fps: f64) -> u16 {
    (100.0 / fps).round().clamp(2.0, 6000.0) as u16
}

impl<W: Write> Animation<W> {
    /// A GIF, `size` pixels wide, of the frames that `survey` has seen, so many a second.
    pub fn begin(out: W, survey: Survey, size: u16, fps: f64) -> io::Result<Self> {
        let shade = |k: usize| colour::at(k as f64 / (HUES - 1) as f64);
        let hues = if survey.has_velocities { std::array::from_fn(shade) } else { [PLAIN; HUES] };
        let height = size + CLOCK as u16;
        let mut encoder =
            gif::Encoder::new(out, size, height, &palette(hues)).map_err(io::Error::other)?;
        encoder.set_repeat(gif::Repeat::Infinite).map_err(io::Error::other)?;
        let canvas = Canvas::new(usize::from(size), usize::from(height));
        Ok(Self {
            encoder,
            canvas,
            size: usize::from(size),
            delay: delay(fps),
            survey,
            view: survey.view(),
        })
    }

    /// Appends a frame, number `index` of the file.
    pub fn add(&mut self, index: usize, frame: &Frame) -> io::Result<()> {
        self.draw(index, frame);
        let picture = gif::Frame {
            width: self.size as u16,
            height: (self.size + CLOCK) as u16,
            delay: self.delay,
            buffer: self.canvas.pixels().into(),
            ..gif::Frame::default()
        };
        self.encoder.write_frame(&picture).map_err(io::Error::other)
    }

    /// Ends the file.
    pub fn finish(self) -> io::Result<()> {
        self.encoder.into_inner().map_err(io::Error::other)?.flush()
    }

    fn draw(&mut self, index: usize, frame: &Frame) {
        self.canvas.clear();
        for row in &frame.rows {
            let share = frame::speed(row) / self.survey.fastest;
            let hue = (share * (HUES - 1) as f64).round() as usize; // NaN, at rest, is 0
            let radius = row.radius / self.view.width * self.size as f64;
            self.canvas.fill_disc(self.pixel(row.position), radius, hue);
        }
        if let Some(side) = self.survey.side {
            let whole = |(x, y): (f64, f64)| (x.round() as i64, y.round() as i64);
            let left_top = whole(self.pixel(DVec2::new(0.0, side)));
            let right_bottom = whole(self.pixel(DVec2::new(side, 0.0)));
            self.canvas.draw_outline(left_top, right_bottom);
        }
        let clock = frame
            .time
            .map_or(format!("frame {index}"), |time| format!("t = {} s", seconds(time, 4)));
        // Two points a pixel where there is room.
        let scale = if self.size >= 240 { 2 } else { 1 };
        self.canvas.write(&clock, ((0.03 * self.size as f64) as i64, 3), scale);
    }

    /// Where a point (m) lies, pixels from the upper left corner.
    fn pixel(&self, at: DVec2) -> (f64, f64) {
        let place = (at - self.view.corner) / self.view.width * self.size as f64;
        (place.x, (CLOCK + self.size) as f64 - place.y)
    }
}

/// The script that makes the animation from `data`, every so many of its frames.
pub fn script(
    stem: &str,
    data: &DataFile,
    survey: &Survey,
    (every, size, fps): (usize, u16, f64),
) -> String {
    let mut text = format!("delay = {}                         # 1/100 s\n", delay(fps));
    let size = f64::from(size);
    text += &gnuplot::head(stem, "An animated GIF of all frames", (size, size + 20.0), "gif");
    text += &gnuplot::ground(survey.view(), survey.side);
    text += "unset xlabel ; unset ylabel ; unset tics ; unset border\n";
    let fill = if survey.has_velocities {
        text += &gnuplot::palette(0.0, survey.fastest, "speed, m/s");
        text += "unset colorbox\n";
        "(snap($1)):(snap($2)):3:(sqrt($4**2 + $5**2)) with circles fs solid noborder lc palette"
            .to_owned()
    } else {
        format!("(snap($1)):(snap($2)):3 with circles fs solid noborder fc rgb '{}'", hex(PLAIN))
    };
    let _ = write!(
        text,
        "set margins at screen 0, at screen 1, at screen 0, at screen {:.4}\n\
         # Centres sit on whole pixels: elsewhere equal small discs would come out unequal.\n\
         pixel = {:e}\nsnap(v) = pixel * floor(v / pixel + 0.5)\n\
         if (!exists('file')) file = {}\ntimes = ''\n\
         # The header lines \"# step .. time_s ..\" as data.\n\
         set datafile commentschars '!'\n\
         stats file using (strcol(1) eq '#' ? (times = times.' '.strcol(5)) : 0, 0) nooutput\n\
         set datafile commentschars\n\
         do for [k=0:{}:{every}] {{\n    \
         set label 1 k < words(times) ? sprintf('t = %.4f s', real(word(times, k + 1))) : sprintf('frame %d', k) at screen 0.03, screen {:.4} front\n    \
         plot file index k every ::0::{} using {fill}\n}}\n",
        size / (size + 20.0),
        survey.view().width / (size - 1.0), // gnuplot's axes end on pixels
        data.expression(),
        survey.frames.saturating_sub(1),
        1.0 - 10.0 / (size + 20.0),
        survey.discs.saturating_sub(1),
    );
    text
}
