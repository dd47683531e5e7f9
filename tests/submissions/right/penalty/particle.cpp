#include "particle.h"
#include <cmath>

Particle::Particle(double px, double py, double vx, double vy, double radius, double mass)
    : p{px, py}, v{vx, vy}, F{0, 0}, radius(radius), mass(mass) {}

void Particle::resetForce(const double gravity[2]) {
    for (int d = 0; d < 2; d++) F[d] = mass * gravity[d];
}

void Particle::addForce(const double f[2], double sign) {
    for (int d = 0; d < 2; d++) F[d] += sign * f[d];
}

// Force on this disc; false if they do not touch.
bool Particle::contactForce(const Particle &other, const Material &mat, double f[2]) const {
    double n[2] = {other.p[0] - p[0], other.p[1] - p[1]};
    double sum = radius + other.radius;
    if (std::fabs(n[0]) > sum || std::fabs(n[1]) > sum) return false;  // far away
    double distance = std::hypot(n[0], n[1]);
    double delta = sum - distance;
    if (delta < 0) return false;
    n[0] /= distance;
    n[1] /= distance;
    double vrn = (v[0] - other.v[0]) * n[0] + (v[1] - other.v[1]) * n[1];
    double size = mat.kn * delta + mat.eta_pair * vrn;
    f[0] = -size * n[0];
    f[1] = -size * n[1];
    return true;
}

void Particle::addWalls(double side, const Material &mat) {
    for (int d = 0; d < 2; d++) {
        double low = radius - p[d];
        double high = p[d] + radius - side;
        if (low > 0) F[d] += mat.kn * low - mat.eta_wall * v[d];
        if (high > 0) F[d] -= mat.kn * high + mat.eta_wall * v[d];
    }
}

void Particle::integrate(double dt) {
    for (int d = 0; d < 2; d++) {
        v[d] += F[d] / mass * dt;
        p[d] += v[d] * dt;
    }
}

double dampingFor(double e, double kn, double m) {
    double l = std::log(e);
    double zeta = -l / std::sqrt(M_PI * M_PI + l * l);
    return 2 * zeta * std::sqrt(kn * m);
}
