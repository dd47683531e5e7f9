//! Pictures of few colours: discs with smooth edges, lines and letters, one byte a pixel.

use super::glyphs;

/// Steps of a disc's smooth edge, from nearly white to full.
const LEVELS: usize = 6;
/// Number of colours that discs may have.
pub(super) const HUES: usize = 15;
/// Paper.
const WHITE: u8 = 0;
/// Lines and letters.
const BLACK: u8 = 1;
/// The first colour of the discs.
const FIRST: u8 = 2;

/// The colours as red, green, blue, one after the other: white, black, and every disc colour in
/// all levels.
pub(super) fn palette(hues: [[u8; 3]; HUES]) -> Vec<u8> {
    let mut palette = vec![0xff, 0xff, 0xff, 0, 0, 0];
    for hue in hues {
        for level in 1..=LEVELS {
            let share = level as f64 / LEVELS as f64;
            palette.extend(hue.map(|c| (255.0 - share * (255.0 - f64::from(c))).round() as u8));
        }
    }
    palette
}

/// A picture being drawn.
pub(super) struct Canvas {
    width: usize,
    height: usize,
    pixels: Vec<u8>,
}

impl Canvas {
    /// A white picture.
    pub fn new(width: usize, height: usize) -> Self {
        Self { width, height, pixels: vec![WHITE; width * height] }
    }

    /// Wipes everything off.
    pub fn clear(&mut self) {
        self.pixels.fill(WHITE);
    }

    /// The pixels, row by row from the top.
    pub fn pixels(&self) -> &[u8] {
        &self.pixels
    }

    /// Fills a disc of colour `hue` around `centre` (pixels from the upper left corner); its edge
    /// is smooth. However small, it is seen.
    pub fn fill_disc(&mut self, centre: (f64, f64), radius: f64, hue: usize) {
        let (x, y) = centre;
        let reach = radius + 1.0;
        if !(x + reach > 0.0 && y + reach > 0.0 && radius >= 0.0) {
            return; // outside, or no number
        }
        let range = |at: f64, end: usize| {
            // `as` sends what is below zero to 0 and what is above to the largest number.
            (at - reach) as usize..((at + reach) as usize).saturating_add(1).min(end)
        };
        let (columns, rows) = (range(x, self.width), range(y, self.height));
        let mut is_seen = false;
        for row in rows {
            for column in columns.clone() {
                let share = coverage((x - column as f64, y - row as f64), radius);
                let level = (share * LEVELS as f64).round() as usize;
                if level > 0 {
                    is_seen = true;
                    self.put_level((column, row), hue, level);
                }
            }
        }
        if !is_seen
            && (x as usize) < self.width
            && (y as usize) < self.height
            && x >= 0.0
            && y >= 0.0
        {
            self.put_level((x as usize, y as usize), hue, 2);
        }
    }

    /// Of two discs in one pixel the one that covers more of it shows.
    fn put_level(&mut self, (column, row): (usize, usize), hue: usize, level: usize) {
        let pixel = &mut self.pixels[row * self.width + column];
        let present = pixel.checked_sub(FIRST).map_or(0, |disc| usize::from(disc) % LEVELS + 1);
        if level >= present {
            *pixel = FIRST + (hue.min(HUES - 1) * LEVELS + level - 1) as u8;
        }
    }

    /// Draws the outline of a rectangle, one pixel wide; parts outside are left out.
    pub fn draw_outline(&mut self, (left, top): (i64, i64), (right, bottom): (i64, i64)) {
        let (width, height) = (self.width as i64, self.height as i64);
        for x in left.max(0)..=right.min(width - 1) {
            self.put_black(x, top);
            self.put_black(x, bottom);
        }
        for y in top.max(0)..=bottom.min(height - 1) {
            self.put_black(left, y);
            self.put_black(right, y);
        }
    }

    /// Writes `text` with its upper left corner at a pixel, in letters of 5 by 7 points of `scale`
    /// pixels.
    pub fn write(&mut self, text: &str, (left, top): (i64, i64), scale: i64) {
        for (k, letter) in text.chars().enumerate() {
            let left = left + k as i64 * 6 * scale;
            for (y, row) in glyphs::rows(letter).into_iter().enumerate() {
                for x in (0..5).filter(|x| row >> (4 - x) & 1 == 1) {
                    for (dx, dy) in (0..scale).flat_map(|dx| (0..scale).map(move |dy| (dx, dy))) {
                        self.put_black(left + x * scale + dx, top + y as i64 * scale + dy);
                    }
                }
            }
        }
    }

    fn put_black(&mut self, x: i64, y: i64) {
        let (width, height) = (self.width as i64, self.height as i64);
        if (0..width).contains(&x) && (0..height).contains(&y) {
            self.pixels[(y * width + x) as usize] = BLACK;
        }
    }
}

/// What part of a pixel a disc covers; `from` is the disc's centre seen from the pixel's corner.
fn coverage(from: (f64, f64), radius: f64) -> f64 {
    let (x, y) = (from.0 - 0.5, from.1 - 0.5);
    let distance_squared = x * x + y * y;
    // The edge cannot pass through a pixel whose middle is farther from it than half a diagonal.
    let (within, beyond) = (radius - 0.71, radius + 0.71);
    if distance_squared >= beyond * beyond {
        return 0.0;
    }
    if within > 0.0 && distance_squared <= within * within {
        return 1.0;
    }
    if radius >= 3.0 {
        // The edge is nearly straight.
        return (radius - distance_squared.sqrt() + 0.5).clamp(0.0, 1.0);
    }
    // Four by four points, evenly spread over the pixel.
    let points = (0..16).map(|k| (f64::from(k % 4) / 4.0 - 0.375, f64::from(k / 4) / 4.0 - 0.375));
    let is_inside =
        |(dx, dy): &(f64, f64)| (x - dx) * (x - dx) + (y - dy) * (y - dy) < radius * radius;
    points.filter(is_inside).count() as f64 / 16.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_disc_covers_its_area() {
        for (radius, centre) in [(1.1, 20.3), (5.0, 20.5), (12.7, 24.1)] {
            let mut canvas = Canvas::new(48, 48);
            canvas.fill_disc((centre, centre), radius, 3);
            let levels = canvas.pixels.iter().filter_map(|p| p.checked_sub(FIRST));
            let area: usize = levels.map(|p| usize::from(p) % LEVELS + 1).sum();
            let expected = std::f64::consts::PI * radius * radius;
            // A level is a sixth of a pixel; errors on the edge's pixels mostly cancel.
            let error = area as f64 / LEVELS as f64 - expected;
            assert!(error.abs() < 0.15 * radius + 0.3, "r = {radius}: off by {error}");
        }
    }

    #[test]
    fn the_smallest_disc_is_seen() {
        let mut canvas = Canvas::new(9, 9);
        canvas.fill_disc((4.5, 4.5), 1e-6, 0);
        assert_eq!(canvas.pixels.iter().filter(|p| **p != WHITE).count(), 1);
    }

    #[test]
    fn what_is_outside_or_no_number_draws_nothing() {
        let mut canvas = Canvas::new(9, 9);
        for x in [-5.0, 1e300, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            canvas.fill_disc((x, 4.0), 2.0, 0);
        }
        canvas.fill_disc((4.0, 4.0), f64::NAN, 0);
        assert!(canvas.pixels.iter().all(|p| *p == WHITE));
    }
}
