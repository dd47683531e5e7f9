//! NeighbourList pairs across a periodic edge.

use glam::DVec2;

use super::{Listed, NeighbourList};

impl NeighbourList {
    /// Lists the discs that may reach a periodic edge before the list is renewed, and adds the pairs that are near across
    /// it to the far ones: they act on each other's images.
    pub(super) fn list_across(&mut self, listed: Listed, skin: f64) {
        let Listed { particles, boundary, .. } = listed;
        self.at_edge.clear();
        if boundary.is_open() {
            return;
        }
        let largest = particles.iter().map(|p| p.radius).fold(0.0, f64::max);
        let reach = 2.0 * largest + skin;
        let places = (0..particles.len() as u32)
            .filter(|&k| boundary.is_at_edge(particles[k as usize].position, reach));
        let mut by_height: Vec<u32> = places.collect();
        let at = |place: u32| &particles[place as usize];
        by_height.sort_unstable_by(|&a, &b| {
            at(a).position.y.total_cmp(&at(b).position.y).then(a.cmp(&b))
        });
        for &a in &by_height {
            for image in images(boundary.period) {
                let p = at(a).position + image;
                let from = by_height.partition_point(|&b| at(b).position.y < p.y - reach);
                let there = by_height[from..].iter();
                for &b in there.take_while(|&&b| at(b).position.y <= p.y + reach) {
                    let near = at(a).radius + at(b).radius + skin;
                    if a < b && at(b).position.distance_squared(p) < near * near {
                        self.far.push([a, b]);
                    }
                }
            }
        }
        self.far.sort_unstable();
        self.far.dedup(); // a box that is hardly wider than two discs
        let is_there = |k: &u32| boundary.is_at_edge(at(*k).position, skin);
        self.at_edge.extend((0..particles.len() as u32).filter(is_there));
    }
}

/// The shifts to all neighbouring images.
fn images(period: DVec2) -> impl Iterator<Item = DVec2> {
    let shifts = |period: f64| if period > 0.0 { vec![0.0, -period, period] } else { vec![0.0] };
    let (xs, ys) = (shifts(period.x), shifts(period.y));
    let all = xs.into_iter().flat_map(move |x| ys.clone().into_iter().map(move |y| (x, y)));
    all.skip(1).map(|(x, y)| DVec2::new(x, y))
}
