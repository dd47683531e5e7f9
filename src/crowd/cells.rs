//! Square cells, row by row or column by column, and discs stored in their order.

use std::mem::take;
use std::ops::Range;

use glam::{DVec2, Vec2Swizzles};

use super::sizes::Sizes;
use super::team::Team;
use crate::particle::Particle;

/// Discs looked at to learn where most of them are.
const SAMPLE: usize = 1000;

/// A grid of cells; discs outside it belong to its nearest cell, so that every disc is somewhere.
#[derive(Default)]
pub(super) struct Cells {
    corner: DVec2, // m
    per_metre: f64,
    /// Cells follow each other along the shorter side of where most discs are, so that neighbours in the
    /// next row lie near in memory; if that is upright, x and y are exchanged here.
    is_upright: bool,
    columns: usize,
    rows: usize,
    /// The first place of each cell's discs, and the end.
    starts: Vec<u32>,
    /// The fraction of their ground that the discs cover.
    pub density: f64,
}

impl Cells {
    /// Cells of at least `reach` (m) where most discs are, at most about one a disc.
    pub fn lay_out(&mut self, particles: &[Particle], sizes: &Sizes, reach: impl Fn(f64) -> f64) {
        let n = particles.len().max(1);
        let (left, right) = usual_range(particles, |p| p.position.x);
        let (low, high) = usual_range(particles, |p| p.position.y);
        let (width, height) = (right - left, high - low);
        self.density = (sizes.areas / (width * height)).clamp(1e-3, 1.0);
        let side = reach(self.density)
            .max((width * height / n as f64).sqrt())
            .max(width.max(height) / n as f64);
        self.corner = DVec2::new(left, low);
        self.per_metre = 1.0 / side;
        let along = |length: f64| ((length / side).max(0.0) as usize).max(1);
        self.is_upright = height < width;
        (self.columns, self.rows) = match self.is_upright {
            true => (along(height), along(width)),
            false => (along(width), along(height)),
        };
    }

    fn column_and_row(&self, position: DVec2) -> (usize, usize) {
        let cell = (position - self.corner) * self.per_metre;
        let cell = if self.is_upright { cell.yx() } else { cell };
        // `as` sends negative numbers and NaN to 0 and large ones to the last cell.
        ((cell.x as usize).min(self.columns - 1), (cell.y as usize).min(self.rows - 1))
    }

    /// The order in which the discs are to be stored: for each place, where its disc is now. Discs of
    /// a cell follow each other by id, so that two at exactly one place are always the same first and
    /// second of their contact.
    pub fn order(&mut self, particles: &[Particle], ids: &[u32], team: &Team) -> Vec<u32> {
        let cells = self.cells_of(particles, team);
        let mut starts = vec![0; self.columns * self.rows + 1];
        for &cell in &cells {
            starts[cell as usize] += 1;
        }
        let mut end = 0;
        for start in &mut starts {
            end += *start;
            *start = end;
        }
        let mut order = vec![0; particles.len()];
        for (now, &cell) in cells.iter().enumerate().rev() {
            let start = &mut starts[cell as usize];
            *start -= 1;
            order[*start as usize] = now as u32;
        }
        self.starts = starts;
        self.order_by_id(&mut order, ids, team);
        order
    }

    /// The cell of each disc.
    fn cells_of(&self, particles: &[Particle], team: &Team) -> Vec<u32> {
        let mut cells = vec![0; particles.len()];
        team.pieces(&mut cells, |first, cells| {
            for (cell, p) in cells.iter_mut().zip(&particles[first..]) {
                let (column, row) = self.column_and_row(p.position);
                *cell = (row * self.columns + column) as u32;
            }
        });
        cells
    }

    /// Puts those of each cell into ascending id.
    fn order_by_id(&self, order: &mut [u32], ids: &[u32], team: &Team) {
        let cells = self.columns * self.rows;
        let each = cells.div_ceil(team.threads());
        let mut order = order;
        let shares = (0..cells).step_by(each).map(|first| {
            let starts = &self.starts[first..=(first + each).min(cells)];
            let length = starts[starts.len() - 1] - starts[0];
            let (mine, rest) = take(&mut order).split_at_mut(length as usize);
            order = rest;
            (starts, mine)
        });
        team.each(shares.collect(), |(starts, order): (&[u32], &mut [u32])| {
            for ends in starts.windows(2).filter(|ends| ends[1] - ends[0] > 1) {
                let in_cell = (ends[0] - starts[0]) as usize..(ends[1] - starts[0]) as usize;
                order[in_cell].sort_unstable_by_key(|&now| ids[now as usize]);
            }
        });
    }

    /// The places of discs in the same and the neighbouring cells of the disc at `place`, without
    /// those before it: the rest of its own cell and the next, and three cells of the row above.
    pub fn ahead_of(&self, place: usize, position: DVec2) -> [Range<usize>; 2] {
        let (column, row) = self.column_and_row(position);
        let right = (column + 1).min(self.columns - 1);
        let start = |row: usize, column: usize| self.starts[row * self.columns + column] as usize;
        let end = |row: usize, column: usize| self.starts[row * self.columns + column + 1] as usize;
        let here = place + 1..end(row, right);
        if row + 1 == self.rows {
            return [here, 0..0];
        }
        [here, start(row + 1, column.saturating_sub(1))..end(row + 1, right)]
    }
}

/// Where most discs are, from a sample of them: one far away must not make every cell huge.
fn usual_range(particles: &[Particle], coordinate: impl Fn(&Particle) -> f64) -> (f64, f64) {
    let stride = particles.len().div_ceil(SAMPLE).max(1);
    let sample = particles.iter().step_by(stride).map(coordinate).filter(|x| x.is_finite());
    let mut sample: Vec<f64> = sample.collect();
    sample.sort_unstable_by(f64::total_cmp);
    match sample.len().checked_sub(1) {
        None => (0.0, 0.0),
        Some(last) => {
            let (low, high) = (sample[last / 50], sample[last - last / 50]);
            let margin = 0.03 * (high - low);
            (low - margin, high + margin)
        }
    }
}

/// Moves the disc at `order[place]` to `place`, for all places, and all that lies beside the discs
/// with them, in place. `order` is used up.
pub(super) fn put_in_order(order: &mut [u32], mut swap: impl FnMut(usize, usize)) {
    for first in 0..order.len() {
        let mut place = first;
        loop {
            let from = std::mem::replace(&mut order[place], place as u32) as usize;
            if from == first || from == place {
                break;
            }
            swap(place, from);
            place = from;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_put_in_order_lies_where_the_order_says() {
        for order in [vec![], vec![0], vec![1, 0], vec![2, 0, 1, 3], vec![4, 3, 0, 1, 2]] {
            let before: Vec<u32> = (0..order.len() as u32).map(|k| 10 * k).collect();
            let mut after = before.clone();
            put_in_order(&mut order.clone(), |a, b| after.swap(a, b));
            let wanted: Vec<u32> = order.iter().map(|&from| before[from as usize]).collect();
            assert_eq!(after, wanted);
        }
    }

    #[test]
    fn neighbours_within_reach_are_ahead_of_one_another_wherever_discs_are() {
        let golden = |k: usize| (0.618_034 * k as f64).fract();
        let spread = |k: usize| DVec2::new(golden(k), golden(7 * k + 3));
        let kinds: [fn(DVec2) -> DVec2; 5] = [
            |place| place,
            |place| DVec2::new(place.x, 10.0 * place.y),
            |place| DVec2::new(place.x, 0.0),
            |place| DVec2::new(100.0 * place.x, place.y),
            |place| if place.x < 0.01 { 1e6 * place } else { place },
        ];
        for kind in kinds {
            let mut discs: Vec<_> =
                (0..400).map(|k| Particle::at_rest(kind(spread(k)), 0.01, 1.0)).collect();
            let (reach, mut cells) = (0.05, Cells::default());
            let team = Team::of(3);
            cells.lay_out(&discs, &Sizes::of(&discs, &team), |_| reach);
            let ids: Vec<u32> = (0..400).rev().collect();
            put_in_order(&mut cells.order(&discs, &ids, &team), |a, b| discs.swap(a, b));
            for (a, p) in discs.iter().enumerate() {
                let [here, above] = cells.ahead_of(a, p.position);
                for (b, q) in discs.iter().enumerate().skip(a + 1) {
                    let is_near = p.position.distance(q.position) < reach;
                    assert!(!is_near || here.contains(&b) || above.contains(&b), "{a} {b}");
                }
            }
        }
    }
}
