//! A disc, its contacts, and how it moves: Eqs. (1) and (3) of the guide.
//!
//! SI units throughout: metres, seconds, kilograms, newtons, joules. "The guide" is the course
//! guideline this program grew from (D'Ambrosio, University of Calabria, 2019).

use glam::DVec2;

/// One disc: where it is, how it moves, what pushes it.
///
/// 64 bytes, one cache line. On entry to and on return from every time step,
/// [`force`](Self::force) belongs to the disc's present position and velocity (under velocity
/// Verlet, which feeds dashpots half a step early, to the half-step velocity).
#[derive(Clone, Copy, Debug, PartialEq)]
#[repr(C, align(64))]
pub struct Particle {
    /// Position of the centre, p.
    pub position: DVec2, // m
    /// Velocity of the centre, v.
    pub velocity: DVec2, // m/s
    /// Sum of all forces on the disc, F.
    pub force: DVec2, // N
    /// Radius, r.
    pub radius: f64, // m
    /// Mass, m.
    pub mass: f64, // kg
}

impl Particle {
    /// A disc at rest, with no force on it yet.
    pub fn at_rest(position: DVec2, radius: f64, mass: f64) -> Self {
        Self { position, velocity: DVec2::ZERO, force: DVec2::ZERO, radius, mass }
    }

    /// First half of Eq. (3): v' = v + a dt, with a = F/m. `dt` in s.
    ///
    /// ```
    /// use glam::DVec2;
    /// let mut disc = parsim2d::particle::Particle::at_rest(DVec2::ZERO, 1e-4, 1e-3);
    /// disc.force = DVec2::new(0.0, -9.81e-3); // its own weight, N
    /// disc.kick(0.5);
    /// disc.drift(0.5); // the *new* velocity moves the disc
    /// assert!((disc.velocity.y + 4.905).abs() < 1e-12);
    /// assert!((disc.position.y + 2.4525).abs() < 1e-12);
    /// ```
    #[inline]
    pub fn kick(&mut self, dt: f64) {
        self.velocity += self.force / self.mass * dt;
    }

    /// Second half of Eq. (3): x' = x + v' dt, with whatever velocity the disc has by now. `dt` in s.
    #[inline]
    pub fn drift(&mut self, dt: f64) {
        self.position += self.velocity * dt;
    }

    /// Kinetic energy, m v²/2, in J.
    #[inline]
    pub fn kinetic_energy(&self) -> f64 {
        0.5 * self.mass * self.velocity.length_squared()
    }
}

/// Two bodies that touch, as a contact law sees them.
///
/// ```text
///        r_i          r_j            n_ij points from i to j
///   i ---------[##]---------- j      overlap delta_n = (r_i + r_j) - |p_i - p_j|, here ##
///      n_ij -->                      approach speed v_rn = (v_i - v_j) . n_ij
/// ```
///
/// A wall is a half-plane: a body of infinite mass whose normal points from the disc to the wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// How deep the bodies have sunk into each other, delta_n.
    pub overlap: f64, // m
    /// Unit vector n from the first body to the second.
    pub normal: DVec2,
    /// Relative normal velocity v_rn, positive while the bodies approach.
    pub approach_speed: f64, // m/s
    /// Reduced mass m_i m_j / (m_i + m_j); the disc's own mass at a wall.
    pub reduced_mass: f64, // kg
}

impl Contact {
    /// The contact of discs `i` and `j`, if they overlap.
    ///
    /// Coincident centres have no direction; they are given the x axis, from `i` to `j`, so that
    /// the answer is finite and the two are driven apart. Callers put the lower id first.
    #[inline]
    pub fn between(i: &Particle, j: &Particle) -> Option<Self> {
        let separation = j.position - i.position;
        let distance_squared = separation.length_squared();
        let reach = i.radius + j.radius;
        if distance_squared < reach * reach {
            let distance = distance_squared.sqrt();
            let normal = if distance > 0.0 { separation / distance } else { DVec2::X };
            Some(Self {
                overlap: reach - distance,
                normal,
                approach_speed: (i.velocity - j.velocity).dot(normal),
                reduced_mass: i.mass * j.mass / (i.mass + j.mass),
            })
        } else {
            None
        }
    }

    /// The contact of disc `i` with the half-plane that begins `distance` metres (negative once
    /// the centre is beyond it) along the unit vector `normal`, if they overlap.
    #[inline]
    pub fn with_wall(i: &Particle, distance: f64, normal: DVec2) -> Option<Self> {
        (distance < i.radius).then(|| Self {
            overlap: i.radius - distance,
            normal,
            approach_speed: i.velocity.dot(normal),
            reduced_mass: i.mass,
        })
    }
}

/// A contact law: a pure function of the contact, never of the particles or the clock.
pub trait ContactLaw: Send {
    /// How hard the bodies push each other apart along the normal, N (negative: they pull).
    fn push(&self, contact: &Contact) -> f64;
    /// The part of [`push`](Self::push) that can be had back as energy, N.
    fn spring(&self, contact: &Contact) -> f64;
    /// Energy stored in the contact, J.
    fn stored_energy(&self, contact: &Contact) -> f64;
    /// The spring and dashpot that this law is for small changes about `contact`, of some overlap: what limits the time
    /// step, and a vibration's period, follow from it. Here from differences of [`push`](Self::push), to five
    /// digits or so, for nobody should have to differentiate to try a law.
    fn linearised(&self, contact: &Contact) -> Linear {
        Linear::measured(|contact| self.push(contact), contact)
    }
}

/// A contact law for small changes about a contact: push = (there) + stiffness d(overlap) + damping d(approach speed).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linear {
    /// How much harder the bodies push for each metre that they are deeper in each other.
    pub stiffness: f64, // N/m
    /// How much harder for each m/s that they approach faster.
    pub damping: f64, // kg/s
}

/// The guide's contact: a linear spring and a dashpot side by side (Cundall and Strack 1979).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SpringDashpot {
    /// Normal stiffness, k_n.
    pub stiffness: f64, // N/m
    /// Normal damping, from which eta_n follows.
    pub damping: Damping,
    /// Whether the dashpot may pull the bodies together as they part, as Eq. (1) says.
    /// `false` clips the force at zero.
    pub tension: bool,
}

impl ContactLaw for SpringDashpot {
    /// Eq. (1): f_c = -k_n delta_n - eta_n v_rn, on body i.
    ///
    /// Both terms lie along n, so the force on i is `-push * n`, on j `+push * n`.
    ///
    /// ```
    /// use glam::DVec2;
    /// use parsim2d::particle::{Contact, ContactLaw, Damping, SpringDashpot};
    /// let damping = Damping::Coefficient(1.5e-3); // kg/s
    /// let law = SpringDashpot { stiffness: 5e4, damping, tension: true };
    /// let contact = Contact {
    ///     overlap: 1e-5,       // m
    ///     normal: DVec2::X,
    ///     approach_speed: 0.5, // m/s
    ///     reduced_mass: 5e-4,  // kg
    /// };
    /// assert!((law.push(&contact) - 0.50075).abs() < 1e-12); // 5e4 * 1e-5 + 1.5e-3 * 0.5 N
    /// ```
    #[inline(always)]
    fn push(&self, contact: &Contact) -> f64 {
        let eta = self.damping.coefficient(self.stiffness, contact.reduced_mass);
        let push = self.stiffness * contact.overlap + eta * contact.approach_speed;
        if self.tension || push > 0.0 { push } else { 0.0 }
    }

    #[inline]
    fn spring(&self, contact: &Contact) -> f64 {
        self.stiffness * contact.overlap
    }

    #[inline]
    fn stored_energy(&self, contact: &Contact) -> f64 {
        0.5 * self.stiffness * contact.overlap * contact.overlap
    }

    /// k_n, and eta_n of the contact's reduced mass; also where a clipped force is 0.
    fn linearised(&self, contact: &Contact) -> Linear {
        let damping = self.damping.coefficient(self.stiffness, contact.reduced_mass);
        Linear { stiffness: self.stiffness, damping }
    }
}

/// Three ways to say how strongly a contact is damped.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Damping {
    /// The damping coefficient eta_n itself, kg/s: the same for pairs and walls (the guide).
    Coefficient(f64),
    /// A rate gamma, 1/s: eta_n = m_eff gamma (the convention of LAMMPS's `gran/hooke`).
    Rate(f64),
    /// The damping ratio zeta: eta_n = 2 zeta sqrt(k_n m_eff). Every contact of the simulation
    /// then has the same restitution.
    Ratio(f64),
}

impl Damping {
    /// The damping coefficient eta_n, kg/s, of a contact of stiffness k_n (N/m) and reduced
    /// mass m_eff (kg).
    ///
    /// ```
    /// use parsim2d::particle::Damping;
    /// assert_eq!(Damping::Rate(1.5e3).coefficient(5e4, 5e-4), 0.75);
    /// assert_eq!(Damping::Ratio(1.0).coefficient(5e4, 5e-4), 10.0); // critical, a guide's pair
    /// ```
    #[inline]
    pub fn coefficient(&self, stiffness: f64, reduced_mass: f64) -> f64 {
        match *self {
            Self::Coefficient(eta) => eta,
            Self::Rate(gamma) => reduced_mass * gamma,
            Self::Ratio(zeta) => 2.0 * zeta * (stiffness * reduced_mass).sqrt(),
        }
    }
}

impl Linear {
    /// The slopes of `push` (N) about `contact`, which must have some overlap: central differences, so small that their curvature
    /// takes off as little as rounding does.
    fn measured(push: impl Fn(&Contact) -> f64, contact: &Contact) -> Self {
        let deeper = |by| push(&Contact { overlap: contact.overlap + by, ..*contact });
        let small = 1e-5 * contact.overlap; // m
        let stiffness = (deeper(small) - deeper(-small)) / (2.0 * small);
        let faster =
            |by| push(&Contact { approach_speed: contact.approach_speed + by, ..*contact });
        // As fast as a vibration of so small a width; not 0, where nothing is stiff.
        let slow = small * (stiffness.abs() / contact.reduced_mass).sqrt().max(1e-9); // m/s
        Self { stiffness, damping: (faster(slow) - faster(-slow)) / (2.0 * slow) }
    }
}
