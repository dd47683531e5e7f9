//! The straight line nearest to measured points: growth rates and orders are its slope.

/// y = intercept + slope x.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Units of y over those of x.
    pub slope: f64,
    /// Units of y.
    pub intercept: f64,
    /// Root mean square distance of the points from the line, in units of y.
    pub scatter: f64,
}

impl Line {
    /// The line with the least sum of squared distances in y (Legendre 1805); none through fewer
    /// than two different x.
    ///
    /// ```
    /// use parsim2d::analysis::line::Line;
    /// let line = Line::through(&[(0.0, 1.0), (1.0, 2.9), (2.0, 5.1)]).unwrap();
    /// assert!((line.slope - 2.05).abs() < 1e-12);
    /// assert!((line.intercept - 0.95).abs() < 1e-12);
    /// assert!((line.scatter - (0.015f64 / 3.0).sqrt()).abs() < 1e-12);
    /// assert_eq!(Line::through(&[(1.0, 1.0), (1.0, 2.0)]), None);
    /// ```
    pub fn through(points: &[(f64, f64)]) -> Option<Self> {
        let n = points.len() as f64;
        let mean = |part: fn(&(f64, f64)) -> f64| points.iter().map(part).sum::<f64>() / n;
        // Distances from the means, so that far-away points lose no digits.
        let (x0, y0) = (mean(|p| p.0), mean(|p| p.1));
        let spread: f64 = points.iter().map(|(x, _)| (x - x0).powi(2)).sum();
        let slope = points.iter().map(|(x, y)| (x - x0) * (y - y0)).sum::<f64>() / spread;
        let off: f64 = points.iter().map(|(x, y)| (y - y0 - slope * (x - x0)).powi(2)).sum();
        let scatter = (off / n).sqrt();
        slope.is_finite().then_some(Self { slope, intercept: y0 - slope * x0, scatter })
    }
}
