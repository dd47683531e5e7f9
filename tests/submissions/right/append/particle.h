#ifndef PARTICLE_H
#define PARTICLE_H
#include <vector>

// All discs, one array for each quantity.
struct Particles {
    int n;
    double radius, mass;
    std::vector<double> x, y, vx, vy, fx, fy;

    Particles(int n, double radius, double mass);
    bool overlaps(int i) const;  // with one of the discs before it?
};

#endif
