//! Words that people ask for and that parsim2d does not have: what it lacks, and what comes nearest.

/// Something that is not there.
#[derive(Debug)]
pub struct Wish {
    /// Flags and keys by which it is asked for, as keys are spelt, with blanks between them.
    words: &'static str,
    /// What is lacking.
    pub lacks: &'static str,
    /// What comes nearest.
    pub nearest: &'static str,
}

const WISHES: &[Wish] = &[
    Wish {
        words: "friction mu mu_s mu_d mu_k kt k_t et e_t tangential gamma_t",
        lacks: "there is no friction yet: contacts push along their normal only",
        nearest: "what takes energy is --restitution, --eta or --gamma",
    },
    Wish {
        words: "rotation spin omega phi angle angular_velocity torque inertia rolling \
                rolling_friction",
        lacks: "discs do not rotate yet: contacts push along their normal only, so that nothing turns them",
        nearest: "a disc has position, velocity, radius and mass",
    },
    Wish {
        words: "periodic periodic_x periodic_y pbc boundary boundaries bc",
        lacks: "there is no periodic box yet",
        nearest: "walls all around, or --no-walls for an open plane",
    },
    Wish {
        words: "contact contact_law contact_model law model hertz hertzian potential lennard_jones \
                lj hooke",
        lacks: "there is one contact law: a linear spring of stiffness --kn with a dashpot, --eta, --gamma or \
                --restitution",
        nearest: "a law of one's own is three functions (CONTRIBUTING.md)",
    },
    Wish {
        words: "young youngs_modulus young_modulus modulus poisson poisson_ratio",
        lacks: "contacts are linear and know no material",
        nearest: "their stiffness is said itself, --kn in N/m",
    },
    Wish {
        words: "temperature temp thermostat langevin noise",
        lacks: "there is no thermostat",
        nearest: "--speed gives discs an rms speed at the start, and --restitution 1 keeps it",
    },
    Wish {
        words: "charge coulomb electric magnetic cohesion adhesion attraction drag viscosity fluid \
                air wind field",
        lacks: "discs feel gravity and contacts only",
        nearest: "a force of one's own is a few lines (examples/my_force.rs)",
    },
    Wish {
        words: "dim dims dimension dimensions ndim 3d three_d z gz depth",
        lacks: "there are two dimensions, x and y up",
        nearest: "nothing in three",
    },
    Wish {
        words: "density rho",
        lacks: "a disc's mass is said itself and not by its density",
        nearest: "--mass in kg, or mass in [[disc]] and [[population]]",
    },
    Wish {
        words: "species types kinds materials polydispersity poly radius_min radius_max rmin rmax \
                radii masses",
        lacks: "discs that differ are said in groups",
        nearest: "[[population]] in a scenario file, each with n, radius, mass and speed",
    },
    Wish {
        words: "width height lx ly box length domain xmax ymax",
        lacks: "the box is a square with a corner at the origin",
        nearest: "its side, --side",
    },
    Wish {
        words: "obstacle obstacles wall hopper funnel plane planes polygon lid",
        lacks: "the only walls are the four sides of the box",
        nearest: "a [[disc]] of a very large mass that is in the way",
    },
    Wish {
        words: "gx gy gravity_x gravity_y gravity_angle tilt incline slope",
        lacks: "gravity is one key",
        nearest: "a number, downward, or a vector with y up: --gravity=[1,-9.81], gravity = [1, -9.81]",
    },
    Wish {
        words: "velocity velocities vx vy v0 v",
        lacks: "velocities are said disc by disc",
        nearest: "velocity = [vx, vy] in [[disc]]; --speed throws all in random directions",
    },
    Wish {
        words: "steps nsteps n_steps nstep iterations tmax t_end duration",
        lacks: "the length of a run is a time, in seconds",
        nearest: "--time; steps are --time over the time step",
    },
    Wish {
        words: "restart continue checkpoint",
        lacks: "a run is continued by a command of its own",
        nearest: "--checkpoint-every, and then parsim2d resume",
    },
    Wish {
        words: "gpu cuda mpi processes cores",
        lacks: "there is one computer and its processor",
        nearest: "--threads",
    },
    Wish {
        words: "verlet leapfrog leap_frog stormer_verlet",
        lacks: "this integrator is not there by that name",
        nearest: "velocity-verlet, which has its positions",
    },
    Wish {
        words: "euler semi_implicit_euler euler_cromer forward_euler",
        lacks: "there are two of Euler's",
        nearest: "symplectic-euler (Eq. (3), also semi-implicit or Euler-Cromer) and explicit-euler (forward)",
    },
    Wish {
        words: "rk4 rk2 runge_kutta gear predictor_corrector beeman rattle",
        lacks: "this integrator is not there",
        nearest: "velocity-verlet; one of one's own is a few lines (examples/my_integrator.rs)",
    },
];

/// What to say of a flag, key or name that is not there, if it is one that people wish for.
///
/// ```
/// use parsim2d::scenario::wished::wish;
/// let friction = wish("--friction").unwrap();
/// assert!(friction.lacks.contains("no friction yet") && friction.nearest.contains("--restitution"));
/// assert!(wish("--radios").is_none());
/// ```
pub fn wish(word: &str) -> Option<&'static Wish> {
    let word = word.trim_start_matches('-').to_lowercase().replace('-', "_");
    WISHES.iter().find(|wish| wish.words.split(' ').any(|known| known == word))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_word_is_there_once_and_spelt_as_a_key() {
        let mut all: Vec<&str> = WISHES.iter().flat_map(|wish| wish.words.split(' ')).collect();
        let count = all.len();
        all.sort_unstable();
        all.dedup();
        assert_eq!(all.len(), count);
        for word in all {
            assert_eq!(word, word.to_lowercase().replace('-', "_"));
            assert!(wish(&format!("--{}", word.replace('_', "-"))).is_some(), "{word}");
        }
    }
}
