//! What tells the curves of a drift study apart.

use crate::figure::colour::OKABE_ITO;
use crate::number::typographic;
use crate::output::drift::{CurveRow, DriftRow};

/// What makes one curve: case, integrator and restitution, and N_t where the curve runs over time.
#[derive(Clone, Debug, PartialEq)]
pub struct Key {
    pub case: String,
    pub integrator: String,
    pub restitution: f64,
    pub nt: f64,
}

impl Key {
    pub fn of_drift(row: &DriftRow) -> Self {
        let (case, integrator) = (row.case.clone(), row.integrator.clone());
        Self { case, integrator, restitution: row.restitution, nt: 0.0 }
    }

    pub fn of_curve(row: &CurveRow) -> Self {
        let (case, integrator) = (row.case.clone(), row.integrator.clone());
        Self { case, integrator, restitution: row.restitution, nt: row.nt }
    }
}

/// The curves of a panel, in the order in which they first come, and what tells them apart.
pub struct Keys {
    pub keys: Vec<Key>,
    pub integrators: Vec<String>,
    pub cases: Vec<String>,
    pub restitutions: Vec<f64>,
    pub nts: Vec<f64>,
}

impl Keys {
    pub fn of(rows: impl Iterator<Item = Key>) -> Self {
        let mut keys: Vec<Key> = Vec::new();
        for key in rows {
            // Curves have many points in a row: the last key is nearly always the same.
            if keys.last() != Some(&key) && !keys.contains(&key) {
                keys.push(key);
            }
        }
        let mut nts = distinct(keys.iter().map(|key| key.nt));
        nts.sort_by(f64::total_cmp);
        Self {
            integrators: distinct(keys.iter().map(|key| key.integrator.clone())),
            cases: distinct(keys.iter().map(|key| key.case.clone())),
            restitutions: distinct(keys.iter().map(|key| key.restitution)),
            nts,
            keys,
        }
    }

    /// The name of a curve: only what differs from the others.
    pub fn name(&self, key: &Key) -> String {
        let mut parts = Vec::new();
        if self.cases.len() > 1 {
            parts.push(key.case.clone());
        }
        let is_first = self.integrators.first() == Some(&key.integrator);
        if self.integrators.len() > 1 && !(is_first && key.nt > 0.0) {
            parts.push(key.integrator.clone());
        }
        if self.restitutions.len() > 1 {
            parts.push(format!("e = {}", typographic(key.restitution, 3)));
        }
        if key.nt > 0.0 {
            parts.push(format!("N_t = {}", key.nt));
        }
        parts.join(", ")
    }

    pub fn is_first_case(&self, key: &Key) -> bool {
        self.cases.first() == Some(&key.case)
    }

    pub fn integrator(&self, key: &Key) -> usize {
        position(&self.integrators, &key.integrator)
    }

    /// A colour for every integrator and restitution.
    pub fn colour(&self, key: &Key) -> &'static str {
        let restitution = position(&self.restitutions, &key.restitution);
        let k = self.integrator(key) * self.restitutions.len() + restitution;
        OKABE_ITO[k % OKABE_ITO.len()]
    }

    /// Radius of a curve's dots, px: later ones are smaller, so that none is hidden.
    pub fn radius(&self, key: &Key) -> f64 {
        3.0 + 1.6 * (self.integrators.len() - 1 - self.integrator(key)) as f64
    }
}

pub fn distinct<T: PartialEq>(values: impl Iterator<Item = T>) -> Vec<T> {
    let mut seen = Vec::new();
    for value in values {
        if !seen.contains(&value) {
            seen.push(value);
        }
    }
    seen
}

pub fn position<T: PartialEq>(all: &[T], one: &T) -> usize {
    all.iter().position(|other| other == one).unwrap_or(0)
}
