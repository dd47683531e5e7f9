# A frame of parsim2d (x y r [vx vy]) as a LAMMPS data file for atom_style sphere. LAMMPS wants a
# diameter and a density, and gives a sphere the mass density * 4/3 pi r^3, in two dimensions too.
#
# Usage: awk -v mass=1e-3 -f frame_to_data.awk FRAME >DATA
BEGIN { pi = atan2(0, -1) }
/^#/ {
    for (k = 2; k < NF; k += 2) {
        if ($k == "n") n = $(k + 1)
        if ($k == "side_m") side = $(k + 1)
    }
    print "discs of parsim2d\n"
    print n " atoms\n1 atom types\n"
    half = 0.005 * side
    print "0 " side " xlo xhi\n0 " side " ylo yhi\n" (-half) " " half " zlo zhi\n"
    print "Atoms # sphere\n"
    next
}
NF {
    id++
    printf "%d 1 %.9g %.17g %s %s 0\n", id, 2 * $3, mass / (4 / 3 * pi * $3 ^ 3), $1, $2
    if (NF > 3) velocity[id] = $4 " " $5
}
END {
    if (!(1 in velocity)) exit
    print "\nVelocities\n"
    for (id = 1; id <= n; id++) print id " " velocity[id] " 0 0 0 0"
}
