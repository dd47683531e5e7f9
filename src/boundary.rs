//! Where space ends: nowhere, or where it begins again.

use glam::DVec2;

/// A space that repeats itself along x, along y, along both, or not at all.
///
/// Discs are kept in [0, period) along a direction that is periodic, and act on each other's nearest image.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Boundary {
    /// The length after which space repeats itself along x and y, m; 0 where it does not.
    pub period: DVec2,
}

impl Boundary {
    /// Whether space repeats itself nowhere.
    #[inline]
    pub fn is_open(&self) -> bool {
        self.period == DVec2::ZERO
    }

    /// Where the image of `other` that is nearest to `place` lies, m.
    ///
    /// ```
    /// use glam::DVec2;
    /// let boundary = parsim2d::boundary::Boundary { period: DVec2::new(1.0, 0.0) };
    /// let image = boundary.nearest_image(DVec2::new(0.125, 0.5), DVec2::new(0.875, 0.5));
    /// assert_eq!(image, DVec2::new(-0.125, 0.5));
    /// ```
    #[inline]
    pub fn nearest_image(&self, place: DVec2, other: DVec2) -> DVec2 {
        let shift = |period: f64, separation: f64| match separation {
            d if d > 0.5 * period => -period,
            d if d < -0.5 * period => period,
            _ => 0.0,
        };
        let separation = other - place;
        let along = |k: usize| match self.period[k] {
            0.0 => 0.0,
            period => shift(period, separation[k]),
        };
        other + DVec2::new(along(0), along(1))
    }

    /// What a disc at `position` that has left is moved by, m: nothing, or one period.
    #[inline]
    pub fn wrap(&self, position: DVec2) -> DVec2 {
        let along = |k: usize| match (self.period[k], position[k]) {
            (0.0, _) => 0.0,
            (period, x) if x >= period => -period,
            (period, x) if x < 0.0 => period,
            _ => 0.0,
        };
        DVec2::new(along(0), along(1))
    }

    /// Whether a disc at `position` is closer than `reach` (m) to where space begins again.
    #[inline]
    pub fn is_at_edge(&self, position: DVec2, reach: f64) -> bool {
        let along = |k: usize| {
            let (period, x) = (self.period[k], position[k]);
            period > 0.0 && (x < reach || x > period - reach)
        };
        along(0) || along(1)
    }
}
