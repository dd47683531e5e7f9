#include "particle.h"

Particles::Particles(int n, double radius, double mass)
    : n(n), radius(radius), mass(mass), x(n), y(n), vx(n), vy(n), fx(n), fy(n) {}

bool Particles::overlaps(int i) const {
    for (int j = 0; j < i; j++) {
        double dx = x[i] - x[j];
        double dy = y[i] - y[j];
        if (dx * dx + dy * dy < 4 * radius * radius) return true;
    }
    return false;
}
