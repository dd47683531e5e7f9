//! What a column of a file of discs may hold, and the names that people give it.

/// What a column holds. SI units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Column {
    /// First coordinate of the centre, m.
    X,
    /// Second coordinate of the centre, m.
    Y,
    /// Third coordinate, m, which discs do not have: passed over.
    Z,
    /// Radius, m.
    Radius,
    /// Diameter, m.
    Diameter,
    /// First component of the velocity, m/s.
    Vx,
    /// Second component of the velocity, m/s.
    Vy,
    /// Mass, kg.
    Mass,
    /// A number that tells the disc from all others.
    Id,
    /// Number of the frame, in files that hold all of them in one table.
    Frame,
    /// Steps done.
    Step,
    /// Simulated time, s.
    Time,
    /// Side of the box, m.
    Side,
    /// Kind of a particle of Poeschel and Schwager's: 0 moves freely, others stand or are driven.
    Kind,
    /// Something else, passed over.
    Other,
}

/// The names of each, in lower case; the first is ours.
const NAMES: [(Column, &[&str]); 13] = [
    (Column::X, &["x", "x_m", "xpos", "x_pos", "posx", "pos_x", "position_x", "xu", "points:0"]),
    (Column::Y, &["y", "y_m", "ypos", "y_pos", "posy", "pos_y", "position_y", "yu", "points:1"]),
    (Column::Z, &["z", "z_m", "zpos", "z_pos", "posz", "pos_z", "position_z", "zu", "points:2"]),
    (Column::Radius, &["r", "radius", "rad", "r_m", "radius_m", "c_radius", "radii"]),
    (Column::Diameter, &["d", "diameter", "diam", "d_m", "diameter_m", "c_diameter"]),
    (Column::Vx, &["vx", "v_x", "velx", "vel_x", "velo_x", "velocity_x", "vx_m_s", "velocity:0"]),
    (Column::Vy, &["vy", "v_y", "vely", "vel_y", "velo_y", "velocity_y", "vy_m_s", "velocity:1"]),
    (Column::Mass, &["m", "mass", "m_kg", "mass_kg", "masses"]),
    (Column::Id, &["id", "ids", "i", "index", "particle_id", "identifier", "particle_identifier"]),
    (Column::Frame, &["frame", "frame_number"]),
    (Column::Step, &["step", "timestep", "time_step"]),
    (Column::Time, &["time_s", "t", "time", "t_s"]),
    (Column::Side, &["side_m", "side"]),
];

/// Units that are ours, as people write them.
const SI: [&str; 13] =
    ["", "-", "1", "m", "m/s", "ms-1", "ms^-1", "m s^-1", "m s-1", "m*s^-1", "kg", "s", "si"];

impl Column {
    /// Its own name; `-` for what is passed over.
    pub fn name(self) -> &'static str {
        NAMES.iter().find(|(column, _)| *column == self).map_or("-", |(_, names)| names[0])
    }

    /// The column of this name, which may have its unit behind it, `x [m]`; [`Other`](Self::Other) if
    /// nobody gives one of ours that name.
    ///
    /// Fails if it is one of ours in another unit than ours.
    ///
    /// ```
    /// use parsim2d::output::frames::column::Column;
    /// assert_eq!(Column::named("Radius [m]"), Ok(Column::Radius));
    /// assert_eq!(Column::named("omega"), Ok(Column::Other));
    /// assert!(Column::named("x (mm)").is_err());
    /// ```
    pub fn named(said: &str) -> Result<Self, String> {
        let plain = said.trim().trim_matches(['"', '\'']).trim();
        let (name, unit) = match plain.split_once(['[', '(']) {
            Some((name, unit)) => (name.trim(), unit.trim_end_matches([']', ')']).trim()),
            None => (plain, ""),
        };
        let name = name.to_lowercase().replace([' ', '.', '-'], "_");
        let is_so_called = |(_, names): &&(Self, &[&str])| names.contains(&name.as_str());
        let column = NAMES.iter().find(is_so_called).map_or(Self::Other, |(column, _)| *column);
        if column != Self::Other && !SI.contains(&unit) {
            return Err(format!(
                "its heading says `{plain}`, and numbers are read in SI units: m, m/s, kg, s"
            ));
        }
        Ok(column)
    }
}
