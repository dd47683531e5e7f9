//! What a box with gravity measures by.

/// The scales of a box with gravity.
pub struct Scales {
    /// Time of a fall from ceiling to floor, frames.
    pub fall: f64,
    /// Speed at its end, m a frame.
    pub speed: f64,
    /// Its way, m.
    pub way: f64,
}
