//! NeighbourList pairs across a periodic edge.

use glam::DVec2;

use super::{Listed, NeighbourList};

impl NeighbourList {
    /// Lists the discs that may reach a periodic edge before the list is renewed, and adds the pairs that are near across
    /// it to the far ones: they act on each other's images.
    pub(super) fn list_across(&mut self, listed: Listed, skin: f64) {
        let Listed { discs, boundary, .. } = listed;
        self.at_edge.clear();
        if boundary.is_open() {
            return;
        }
        let largest = discs.radii.iter().copied().fold(0.0, f64::max);
        let reach = 2.0 * largest + skin;
        let position = |place: u32| discs.phases[place as usize].position();
        let radius = |place: u32| discs.radii[place as usize];
        let places = 0..discs.count() as u32;
        let is_there = |reach: f64| move |k: &u32| boundary.is_at_edge(position(*k), reach);
        let mut by_height: Vec<u32> = places.clone().filter(is_there(reach)).collect();
        by_height
            .sort_unstable_by(|&a, &b| position(a).y.total_cmp(&position(b).y).then(a.cmp(&b)));
        for &a in &by_height {
            for image in images(boundary.period) {
                let p = position(a) + image;
                let from = by_height.partition_point(|&b| position(b).y < p.y - reach);
                let there = by_height[from..].iter();
                for &b in there.take_while(|&&b| position(b).y <= p.y + reach) {
                    let near = radius(a) + radius(b) + skin;
                    if a < b && position(b).distance_squared(p) < near * near {
                        self.far.push([a, b]);
                    }
                }
            }
        }
        self.far.sort_unstable();
        self.far.dedup(); // a box that is hardly wider than two discs
        self.at_edge.extend(places.filter(is_there(skin)));
    }
}

/// The shifts to all neighbouring images.
fn images(period: DVec2) -> impl Iterator<Item = DVec2> {
    let shifts = |period: f64| if period > 0.0 { vec![0.0, -period, period] } else { vec![0.0] };
    let (xs, ys) = (shifts(period.x), shifts(period.y));
    let all = xs.into_iter().flat_map(move |x| ys.clone().into_iter().map(move |y| (x, y)));
    all.skip(1).map(|(x, y)| DVec2::new(x, y))
}
