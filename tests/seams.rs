//! The engine's seams, each with a small stand-in for what will join there: a thousand discs and more are stepped by the
//! engine on 1, 2 and 3 threads, and held to the bits of a plain step written out here, all pairs and no lists.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use glam::DVec2;
use parsim2d::boundary::Boundary;
use parsim2d::engine::{Body, Contacts, Engine, Interaction, PairForces, PairLaw, Pairwise};
use parsim2d::field::Field;
use parsim2d::force::HalfPlane;
use parsim2d::integrator::{Integrator, Motion, SymplecticEuler};
use parsim2d::particle::{Contact, ContactLaw, Damping, Particle, SpringDashpot};
use parsim2d::simulation::{Simulation, State};
use parsim2d::wall::{Nearest, Wall};

const RADIUS: f64 = 5e-4; // m
const MASS: f64 = 1e-3; // kg
const STIFFNESS: f64 = 5e4; // N/m
const DT: f64 = 8e-6; // s: about 55 steps a contact
const SIDE: f64 = 0.04; // m

fn spring_dashpot() -> SpringDashpot {
    SpringDashpot { stiffness: STIFFNESS, damping: Damping::Coefficient(1.0), tension: true }
}

/// Numbers in [0, 1) without a pattern that matters.
fn golden(k: usize) -> f64 {
    (0.618_033_988_749 * k as f64).fract()
}

/// 1089 discs on a shaken lattice, thrown: they meet all the time.
fn discs() -> Vec<Particle> {
    let place = |k: usize| (k as f64 + 0.5) * SIDE / 33.0;
    let disc = |k: usize| {
        let shake = DVec2::new(golden(k) - 0.5, golden(5 * k + 2) - 0.5) * 2e-4;
        let position = DVec2::new(place(k % 33), place(k / 33)) + shake;
        let mut disc = Particle::at_rest(position, RADIUS * (0.8 + 0.4 * golden(3 * k)), MASS);
        disc.velocity = 2.0 * DVec2::new(golden(7 * k + 1) - 0.5, golden(11 * k + 3) - 0.5);
        disc
    };
    (0..33 * 33).map(disc).collect()
}

/// What acts, in the plain step and in the engine's.
#[derive(Clone)]
struct Setting<I> {
    interaction: I,
    gravity: DVec2,
    planes: Vec<HalfPlane>,
    walls: Vec<Arc<dyn Wall>>,
    fields: Vec<Arc<dyn Field>>,
    boundary: Boundary,
    kinds: Vec<u32>,
}

impl<I: Interaction> Setting<I> {
    fn of(interaction: I) -> Self {
        Self {
            interaction,
            gravity: DVec2::new(0.0, -9.81),
            planes: HalfPlane::square(SIDE).to_vec(),
            walls: Vec::new(),
            fields: Vec::new(),
            boundary: Boundary::default(),
            kinds: Vec::new(),
        }
    }

    /// In a space with these periods, without the walls that stood there.
    fn in_period(mut self, period: DVec2) -> Self {
        self.boundary = Boundary { period };
        self.planes.retain(|plane| period.dot(plane.normal) == 0.0);
        self
    }

    fn engine(&self, discs: &[Particle], threads: usize) -> Simulation {
        let interaction = self.interaction.clone();
        let planes = self.planes.clone();
        let mut engine = Engine::of(discs.to_vec(), self.gravity, interaction, planes, DT, threads);
        if !self.kinds.is_empty() {
            engine = engine.of_kinds(&self.kinds);
        }
        engine = engine.in_space(self.boundary).with_walls(self.walls.clone());
        engine = engine.in_fields(self.fields.clone());
        Simulation::of(Box::new(engine), Box::new(SymplecticEuler), DT)
    }

    fn plain(&self, discs: &[Particle]) -> Plain<I> {
        let mut plain = Plain {
            setting: self.clone(),
            discs: discs.to_vec(),
            memory: BTreeMap::new(),
            steps: 0,
            touched: 0,
            stored: 0.0,
        };
        plain.add_up(0.0);
        plain
    }
}

/// The plain step.
struct Plain<I> {
    setting: Setting<I>,
    discs: Vec<Particle>,
    memory: BTreeMap<[u32; 2], f64>,
    steps: u64,
    /// Pairs that acted, in all steps.
    touched: u64,
    /// Energy stored in fields, at walls and in pairs, J.
    stored: f64,
}

impl<I: Interaction> Plain<I> {
    fn body(&self, id: usize) -> Body {
        let Particle { position, velocity, radius, mass, .. } = self.discs[id];
        let kind = self.setting.kinds.get(id).copied().unwrap_or(0);
        Body { id: id as u32, kind, position, velocity, radius, mass }
    }

    fn step(&mut self) {
        for disc in &mut self.discs {
            disc.kick(DT);
            disc.drift(DT);
        }
        self.bring_back();
        self.steps += 1;
        self.add_up(DT);
    }

    /// Brings discs that have left a periodic space back into it.
    fn bring_back(&mut self) {
        for disc in &mut self.discs {
            let shift = self.setting.boundary.wrap(disc.position);
            if shift != DVec2::ZERO {
                disc.position += shift;
            }
        }
    }

    /// Takes a disc out, with what its pairs remember; higher ids move down by one.
    fn remove(&mut self, id: u32) {
        self.discs.remove(id as usize);
        if !self.setting.kinds.is_empty() {
            self.setting.kinds.remove(id as usize);
        }
        let renumbered = |other: u32| other - u32::from(other > id);
        self.memory = std::mem::take(&mut self.memory)
            .into_iter()
            .filter(|(ids, _)| !ids.contains(&id))
            .map(|(ids, memory)| (ids.map(renumbered), memory))
            .collect();
    }

    /// Puts one more in, of kind 0.
    fn insert(&mut self, disc: Particle) {
        self.discs.push(disc);
        if !self.setting.kinds.is_empty() {
            self.setting.kinds.push(0);
        }
        self.add_up(0.0);
    }

    fn add_up(&mut self, elapsed: f64) {
        self.begin_sums(self.steps as f64 * DT);
        self.add_pairs(elapsed);
    }

    /// Weight, fields, walls that move, walls.
    fn begin_sums(&mut self, time: f64) {
        let Setting { gravity, planes, walls, fields, interaction, .. } = self.setting.clone();
        let at_walls = interaction.at_walls();
        self.stored = 0.0;
        for (id, disc) in (0..).zip(&mut self.discs) {
            disc.force = disc.mass * gravity;
            for field in &fields {
                let force = field.force(disc, id, time);
                disc.force += force;
                self.stored += field.stored_energy(disc, id, time).unwrap_or(0.0);
            }
            for wall in &walls {
                let nearest = wall.nearest(disc.position, time);
                let mut seen = *disc;
                seen.velocity -= nearest.velocity;
                let contact = Contact::with_wall(&seen, nearest.distance, nearest.normal);
                if let Some(contact) = contact {
                    disc.force -= at_walls.push(&contact) * contact.normal;
                    self.stored += at_walls.stored_energy(&contact);
                }
            }
            for plane in &planes {
                let distance = plane.distance(disc.position);
                if let Some(contact) = Contact::with_wall(disc, distance, plane.normal) {
                    disc.force -= at_walls.push(&contact) * contact.normal;
                    self.stored += at_walls.stored_energy(&contact);
                }
            }
        }
    }

    /// Pairs, in ascending ids.
    fn add_pairs(&mut self, elapsed: f64) {
        let Setting { boundary, interaction, .. } = self.setting.clone();
        let pairs = interaction.pairs();
        let memories = std::mem::take(&mut self.memory); // those of pairs that act are put back
        for i in 0..self.discs.len() {
            for j in i + 1..self.discs.len() {
                let mut bodies = [self.body(i), self.body(j)];
                let image = match boundary.is_open() {
                    true => bodies[1].position,
                    false => boundary.nearest_image(bodies[0].position, bodies[1].position),
                };
                let range = |body: &Body| pairs.range(body.radius, body.kind);
                let reach = range(&bodies[0]) + range(&bodies[1]);
                if bodies[0].position.distance_squared(image) > reach * reach {
                    continue;
                }
                bodies[1].position = image;
                let remembered = memories.get(&[i as u32, j as u32]).copied().unwrap_or(0.0);
                let memory = match elapsed > 0.0 {
                    true => pairs.advance(&bodies, remembered, elapsed),
                    false => remembered,
                };
                match pairs.forces(&bodies, memory) {
                    None => {}
                    Some(PairForces { on, stored_energy, .. }) => {
                        self.touched += 1;
                        self.stored += stored_energy;
                        self.memory.insert([i as u32, j as u32], memory);
                        self.discs[i].force += on[0];
                        self.discs[j].force += on[1];
                    }
                }
            }
        }
    }
}

/// Steps both ways and holds the engine's discs to the plain ones. Says how many lists that took.
fn hold<I: Interaction>(name: &str, setting: &Setting<I>, discs: &[Particle], steps: u64) -> u64 {
    let mut lists = 0;
    let mut plain = setting.plain(discs);
    (0..steps).for_each(|_| plain.step());
    assert!(plain.touched > 1000, "{name} is no test: {} pairs acted", plain.touched);
    for threads in [1, 2, 3] {
        let mut engine = setting.engine(discs, threads);
        if threads == 2 {
            engine.keep_work_ledger(); // springs are added up apart from the rest
        }
        engine.step_until(steps);
        lists = engine.lists_made();
        assert!(lists > 2, "{name}: {lists} lists");
        assert_same(&format!("{name} on {threads} threads"), engine.particles(), &plain.discs);
        let (here, there) = (engine.stored_energy(), plain.stored);
        assert!((here - there).abs() <= 1e-12 * there, "{name}: {here} J of {there}"); // in another order
    }
    lists
}

fn assert_same(name: &str, engine: &[Particle], plain: &[Particle]) {
    assert_eq!(engine.len(), plain.len(), "{name}");
    for (id, (a, b)) in engine.iter().zip(plain).enumerate() {
        assert_eq!(a, b, "{name}, disc {id}");
    }
}

/// Sliding contacts that remember how far they have slid, as Cundall and Strack's shear spring does: the stretch, m.
#[derive(Clone, Debug)]
struct ShearSpring(SpringDashpot);

impl ShearSpring {
    const STIFFNESS: f64 = 1e4; // N/m
    const MU: f64 = 0.3;
}

impl PairLaw for ShearSpring {
    const HAS_MEMORY: bool = true;

    fn range(&self, radius: f64, _kind: u32) -> f64 {
        radius
    }

    fn advance(&self, [i, j]: &[Body; 2], stretch: f64, elapsed: f64) -> f64 {
        match Contact::between(&i.particle(), &j.particle()) {
            None => stretch, // it is not for the law to forget
            Some(contact) => {
                let tangent = contact.normal.perp();
                let stretch = stretch + (i.velocity - j.velocity).dot(tangent) * elapsed;
                let most = Self::MU * self.0.push(&contact).abs() / Self::STIFFNESS;
                stretch.clamp(-most, most)
            }
        }
    }

    fn forces(&self, [i, j]: &[Body; 2], stretch: f64) -> Option<PairForces> {
        let contact = Contact::between(&i.particle(), &j.particle())?;
        let shear = Self::STIFFNESS * stretch * contact.normal.perp();
        let on_j = self.0.push(&contact) * contact.normal + shear;
        let spring = self.0.spring(&contact) * contact.normal + shear;
        Some(PairForces {
            on: [-on_j, on_j],
            conservative: [-spring, spring],
            stored_energy: self.0.stored_energy(&contact)
                + 0.5 * Self::STIFFNESS * stretch * stretch,
            overlap: contact.overlap,
        })
    }
}

fn sliding() -> Setting<Pairwise<ShearSpring, SpringDashpot>> {
    let law = spring_dashpot();
    Setting::of(Pairwise { pairs: ShearSpring(law), at_walls: law })
}

/// The same where space repeats itself along x: pairs across the edge remember, too.
fn sliding_across() -> Setting<Pairwise<ShearSpring, SpringDashpot>> {
    sliding().in_period(DVec2::new(SIDE, 0.0))
}

#[test]
fn a_law_with_a_memory_for_each_contact_has_the_bits_of_the_plain_step() {
    hold("shear", &sliding(), &discs(), 400);
    hold("shear across", &sliding_across(), &discs(), 250);
}

#[test]
fn memories_survive_a_checkpoint_and_another_number_of_threads() {
    for (name, setting) in [("shear", sliding()), ("shear across", sliding_across())] {
        let state = hold_resumed(name, &setting, &discs());
        let remembered = state.arrays().iter().any(|(name, _)| *name == "pair_memory");
        assert!(remembered, "nothing is remembered: no test");
    }
}

#[test]
fn kinds_and_walls_that_move_are_found_again_after_a_checkpoint() {
    hold_resumed("chase", &chase(), &discs());
    hold_resumed("shaker", &shaken(), &slow_discs());
}

/// Steps to a checkpoint and on from it, and holds what comes out to the plain discs. Gives the checkpoint back.
fn hold_resumed<I: Interaction>(name: &str, setting: &Setting<I>, discs: &[Particle]) -> State {
    let mut plain = setting.plain(discs);
    (0..300).for_each(|_| plain.step());
    let mut first = setting.engine(discs, 2);
    first.step_until(110);
    drop(first.state()); // what was made for it is not kept for the next
    first.step_until(111);
    let arrays = first.state().arrays().into_iter();
    let arrays = arrays.map(|(name, array)| (name.to_owned(), array)).collect();
    let state = State::from_arrays(arrays).unwrap();
    for threads in [1, 3] {
        let mut second = setting.engine(discs, threads);
        second.set_state(&state);
        assert_eq!(second.state().arrays(), state.arrays(), "{name}");
        second.step_until(300);
        let name = format!("{name} resumed on {threads} threads");
        assert_same(&name, second.particles(), &plain.discs);
    }
    state
}

/// Discs of kind 0 flee those of kind 1, which follow them; among their like the lower id pushes harder. With a reach of its
/// own, and no reaction.
#[derive(Clone, Debug)]
struct Chase;

impl PairLaw for Chase {
    fn range(&self, radius: f64, kind: u32) -> f64 {
        if kind == 0 { 2.2 * radius } else { 1.3 * radius }
    }

    fn forces(&self, [i, j]: &[Body; 2], _memory: f64) -> Option<PairForces> {
        let reach = self.range(i.radius, i.kind) + self.range(j.radius, j.kind);
        let separation = j.position - i.position;
        let distance = separation.length();
        if distance >= reach {
            return None;
        }
        let size = 20.0 * (1.0 - distance / reach); // N
        let along = separation / distance;
        let on = match (i.kind, j.kind) {
            (0, 1) => [-size * along, -0.5 * size * along],
            (1, 0) => [0.5 * size * along, size * along],
            _ => [-0.9 * size * along, size * along],
        };
        Some(PairForces { on, ..PairForces::default() })
    }
}

fn chase() -> Setting<Pairwise<Chase, SpringDashpot>> {
    let mut setting = Setting::of(Pairwise { pairs: Chase, at_walls: spring_dashpot() });
    setting.kinds = (0..33 * 33).map(|k| u32::from(golden(13 * k) < 0.3)).collect();
    setting
}

#[test]
fn a_pair_potential_with_its_own_reach_kinds_and_no_reaction_has_the_bits_of_the_plain_step() {
    let (setting, discs) = (chase(), discs());
    hold("chase", &setting, &discs, 300);
    let mut like = setting.clone();
    like.kinds = Vec::new();
    let (mut one, mut other) = (setting.engine(&discs, 1), like.engine(&discs, 1));
    one.step_until(50);
    other.step_until(50);
    assert_ne!(one.state_hash(), other.state_hash(), "kinds make no difference");
}

/// A harmonic trap about the middle.
struct Trap;

impl Trap {
    const STIFFNESS: f64 = 0.5; // N/m
}

impl Field for Trap {
    fn force(&self, disc: &Particle, _id: u32, _time: f64) -> DVec2 {
        -Self::STIFFNESS * (disc.position - DVec2::splat(0.5 * SIDE))
    }

    fn stored_energy(&self, disc: &Particle, _id: u32, _time: f64) -> Option<f64> {
        Some(0.5 * Self::STIFFNESS * disc.position.distance_squared(DVec2::splat(0.5 * SIDE)))
    }
}

/// A wind that comes and goes and stores nothing; discs of odd id feel it twice.
struct Wind;

impl Field for Wind {
    fn force(&self, _disc: &Particle, id: u32, time: f64) -> DVec2 {
        0.05 * f64::from(1 + id % 2) * DVec2::from_angle(3000.0 * time) // N
    }
}

#[test]
fn fields_that_hang_on_place_time_and_id_have_the_bits_of_the_plain_step() {
    let mut setting = Setting::of(Contacts { law: spring_dashpot() });
    setting.fields = vec![Arc::new(Trap), Arc::new(Wind)];
    hold("trap and wind", &setting, &discs(), 300);
}

#[test]
fn a_field_that_stores_energy_supplies_none_and_one_that_stores_none_supplies() {
    let supplied = |field: Arc<dyn Field>| {
        let mut setting = Setting::of(Contacts { law: spring_dashpot() });
        setting.fields = vec![field];
        let mut engine = setting.engine(&discs(), 2);
        engine.keep_work_ledger();
        engine.step_until(300);
        engine.works().expect("there is a ledger").supplied().abs()
    };
    let kinetic: f64 = discs().iter().map(Particle::kinetic_energy).sum();
    let (by_trap, by_wind) = (supplied(Arc::new(Trap)), supplied(Arc::new(Wind)));
    assert!(by_trap < 1e-12 * kinetic && by_wind > 1e-3 * kinetic, "{by_trap} {by_wind} {kinetic}");
}

/// A floor that goes up and down, from below all discs; faster than they are.
struct Shaker;

impl Shaker {
    const AMPLITUDE: f64 = 2e-3; // m
    const RATE: f64 = 1000.0; // 1/s
}

impl Wall for Shaker {
    fn nearest(&self, point: DVec2, time: f64) -> Nearest {
        let phase = Self::RATE * time;
        let height = -Self::AMPLITUDE * phase.cos();
        let velocity = DVec2::Y * Self::AMPLITUDE * Self::RATE * phase.sin();
        Nearest { distance: point.y - height, normal: DVec2::NEG_Y, velocity }
    }

    fn top_speed(&self) -> f64 {
        Self::AMPLITUDE * Self::RATE
    }
}

fn shaken() -> Setting<Contacts<SpringDashpot>> {
    let mut setting = Setting::of(Contacts { law: spring_dashpot() });
    setting.planes.remove(2); // the floor
    setting.walls = vec![Arc::new(Shaker)];
    setting
}

/// Discs that do not come far in the time in which the floor does.
fn slow_discs() -> Vec<Particle> {
    let mut discs = discs();
    discs.iter_mut().for_each(|disc| disc.velocity *= 0.2);
    discs
}

#[test]
fn a_wall_that_moves_has_the_bits_of_the_plain_step() {
    hold("shaker", &shaken(), &slow_discs(), 400);
    let mut alone = shaken();
    alone.planes.clear(); // no other wall has the discs near the floor looked at
    hold("shaker alone", &alone, &slow_discs(), 250); // some are pressed into it then: what that stores is held, too
}

#[test]
fn what_a_wall_that_moves_supplies_closes_the_ledger() {
    // The error of Eq. (3) in a contact is of first order: half the step, half of it.
    let error = |dt: f64| {
        let setting = shaken();
        let engine =
            Engine::of(discs(), setting.gravity, setting.interaction, setting.planes, dt, 2);
        let engine = engine.with_walls(setting.walls);
        let mut run = Simulation::of(Box::new(engine), Box::new(SymplecticEuler), dt);
        run.keep_work_ledger();
        let energy = |run: &Simulation| {
            run.sum_over(|p| p.kinetic_energy() + 9.81 * p.mass * p.position.y)
                + run.stored_energy()
        };
        let kinetic = |run: &Simulation| run.sum_over(Particle::kinetic_energy);
        let (start, kinetic_start) = (energy(&run), kinetic(&run));
        run.step_until((4e-3 / dt).round() as u64);
        let works = run.works().expect("there is a ledger");
        let (supplied, dissipated) = (works.supplied(), works.dissipated());
        assert!(supplied.abs() > 0.05 * start, "{supplied} of {start}: no test");
        // Booked kick by kick: rounding of some 1e5 terms.
        let booked = (works.total() - (kinetic(&run) - kinetic_start)).abs();
        assert!(booked < 1e-11 * start, "{booked}");
        (energy(&run) + dissipated - supplied - start) / start
    };
    let (coarse, fine) = (error(DT), error(0.25 * DT));
    assert!(coarse.abs() < 0.05, "{coarse}"); // 55 steps a contact
    assert!(fine.abs() < 0.5 * coarse.abs(), "{coarse} {fine}"); // a fourth is expected
}

#[test]
fn a_periodic_edge_has_the_bits_of_the_plain_step() {
    for (name, period) in [("along x", DVec2::new(SIDE, 0.0)), ("along both", DVec2::splat(SIDE))] {
        let mut setting = Setting::of(Contacts { law: spring_dashpot() }).in_period(period);
        if period.y > 0.0 {
            setting.gravity = DVec2::ZERO;
        }
        let lists = hold(name, &setting, &discs(), 500);
        assert!(lists < 20, "{lists} lists: does each disc that crosses want a new one?"); // 15
    }
}

#[test]
fn a_disc_removed_and_one_added_between_steps_leave_the_bits_of_the_plain_step() {
    hold_changed("shear", &sliding());
    hold_changed("chase", &chase());
}

/// Takes some discs out and puts another in elsewhere. The next by id of each gets its number, and would be mistaken for it
/// if what its pairs remember were still there: both have partners.
fn hold_changed<I: Interaction>(name: &str, setting: &Setting<I>) {
    let mut new = Particle::at_rest(DVec2::new(0.0181, 0.0207), 3e-4, 5e-4);
    new.velocity = DVec2::new(0.5, -0.5);
    let mut plain = setting.plain(&discs());
    let gone = loop {
        plain.step();
        let partners = |id: u32| plain.memory.range([id, 0]..[id + 1, 0]).map(|(ids, _)| ids[1]);
        let is_mistakable = |id: &u32| {
            let lowest = partners(*id + 1).next();
            lowest.is_some_and(|lowest| partners(*id).any(|partner| partner > lowest))
        };
        let gone: BTreeSet<u32> = (0..33 * 33).filter(is_mistakable).take(12).collect();
        if plain.steps > 100 && gone.len() == 12 {
            break gone;
        }
        assert!(plain.steps < 300, "{name}: {} discs that can be mistaken", gone.len());
    };
    let changed = plain.steps;
    gone.iter().rev().for_each(|id| plain.remove(*id)); // higher ids first: lower ones stay
    plain.insert(new);
    (0..150).for_each(|_| plain.step());
    for threads in [1, 2, 3] {
        let mut engine = setting.engine(&discs(), threads);
        engine.keep_work_ledger();
        engine.step_until(changed);
        change(&mut engine, &gone, new);
        engine.step_until(changed + 150);
        assert_same(&format!("{name} on {threads} threads"), engine.particles(), &plain.discs);
    }
}

/// Takes the discs of these ids out and puts a new one in, and holds the energies that are booked to those that came.
fn change(engine: &mut Simulation, gone: &BTreeSet<u32>, new: Particle) {
    let energies = |run: &Simulation| {
        let potential = |p: &Particle| 9.81 * p.mass * p.position.y;
        let stored = run.sum_over(potential) + run.stored_energy();
        DVec2::new(run.sum_over(Particle::kinetic_energy), stored)
    };
    let inflow = |run: &Simulation| {
        let account = run.works().expect("there is a ledger")[parsim2d::work::Channel::Inflow];
        DVec2::new(account.work.value(), account.beside.value())
    };
    let (before, booked) = (energies(engine), inflow(engine));
    let taken = gone.iter().rev().map(|id| engine.remove(*id as usize).kinetic_energy());
    let taken: f64 = taken.sum();
    engine.insert(new);
    let (came, booked) = (energies(engine) - before, inflow(engine) - booked);
    let kinetic = new.kinetic_energy() - taken;
    assert!((booked.x - kinetic).abs() < 1e-15, "{booked}");
    assert!((booked - came).length() < 1e-12, "{booked} {came}"); // sums of 1089 terms of 1e-4
}

/// Overdamped motion in a bath: x' = x + (F dt + noise) / gamma, with a random number for each step and disc.
struct Overdamped {
    step: u64,
}

impl Overdamped {
    const GAMMA: f64 = 2.0; // kg/s

    /// Two numbers in [-0.5, 0.5) that hang on step and id alone (splitmix64).
    fn noise(step: u64, id: u32) -> DVec2 {
        let mix = |key: u64| {
            let mut z = key.wrapping_add(0x9e37_79b9_7f4a_7c15);
            z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
            ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
        };
        let key = step << 32 | u64::from(id);
        DVec2::new(mix(2 * key), mix(2 * key + 1))
    }

    fn moved(disc: &mut Particle, id: u32, step: u64, dt: f64) {
        let strength = if step % 50 == 49 { 100.0 } else { 0.2 }; // m/s: now and then farther than a list is good for
        disc.velocity = disc.force / Self::GAMMA + strength * Self::noise(step, id);
        disc.drift(dt);
    }
}

impl Integrator for Overdamped {
    fn step(&mut self, discs: &mut dyn Motion, dt: f64) {
        let step = self.step;
        discs.each(&|id, disc| Self::moved(disc, id, step, dt));
        self.step += 1;
        discs.update_forces();
    }
}

#[test]
fn an_overdamped_integrator_with_noise_by_key_has_the_bits_of_the_plain_step() {
    let closed = Setting::of(Contacts { law: spring_dashpot() });
    let across = closed.clone().in_period(DVec2::new(SIDE, 0.0));
    for (name, setting) in [("closed", closed), ("across", across)] {
        let mut plain = setting.plain(&discs());
        for step in 0..300 {
            for (id, disc) in (0..).zip(&mut plain.discs) {
                Overdamped::moved(disc, id, step, DT);
            }
            plain.bring_back();
            plain.add_up(0.0);
        }
        assert!(plain.touched > 1000);
        for threads in [1, 2, 3] {
            let mut engine = setting.engine(&discs(), threads);
            engine.set_integrator(Box::new(Overdamped { step: 0 }));
            engine.step_until(300);
            let lists = engine.lists_made();
            assert!(lists > 2 && lists < 150, "{name}: {lists} lists");
            assert_same(&format!("{name} on {threads} threads"), engine.particles(), &plain.discs);
        }
    }
}
