//! When it is, for what moves by itself.

/// The times of the present step, of the forces that were asked for last, and of the list.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Moment {
    from: f64,
    to: f64,
    /// Time of drift since the step began, s.
    drifted: f64,
    of_forces: f64,
    of_list: f64,
}

impl Moment {
    /// A step begins, which goes `from` one time `to` another, s.
    pub fn begin_step(&mut self, from: f64, to: f64) {
        *self = Self { from, to, drifted: 0.0, ..*self };
    }

    /// Discs drift for `dt` s.
    pub fn drift(&mut self, dt: f64) {
        self.drifted += dt;
    }

    /// Forces are asked for: they belong to the present time.
    ///
    /// Once discs have drifted for a whole step that is the step's end as the clock has it, so that forces that are added up
    /// again have the same bits.
    pub fn ask_for_forces(&mut self) {
        let whole = 1.0 - 1e-9; // of a step: sums of its parts are rounded
        let is_over = self.drifted >= whole * (self.to - self.from) && self.drifted > 0.0;
        self.of_forces = if is_over { self.to } else { self.from + self.drifted };
    }

    /// When forces are added up, s.
    pub fn of_forces(&self) -> f64 {
        self.of_forces
    }

    /// Time since the list was made, s.
    pub fn since_list(&self) -> f64 {
        (self.of_forces - self.of_list).abs()
    }

    /// A list is made.
    pub fn list(&mut self) {
        self.of_list = self.of_forces;
    }

    /// When forces were added up and when the list was made, s.
    pub fn times(&self) -> [f64; 2] {
        [self.of_forces, self.of_list]
    }

    /// The moment of which these were the [`times`](Self::times).
    pub fn of([of_forces, of_list]: [f64; 2]) -> Self {
        Self { from: of_forces, to: of_forces, drifted: 0.0, of_forces, of_list }
    }
}
