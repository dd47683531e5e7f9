#include "particle.h"
#include <cmath>

Particle::Particle(double x, double y, double r, double m)
    : x(x), y(y), vx(0), vy(0), fx(0), fy(0), r(r), m(m) {}

void Particle::startForce(double g) {
    fx = 0;
    fy = -m * g;
}

// Eq. (1) between two discs; the normal goes from this disc to the other.
void Particle::touch(Particle &other, double kn, double eta) {
    double dx = other.x - x;
    double dy = other.y - y;
    double d = sqrt(dx * dx + dy * dy);
    double overlap = r + other.r - d;
    if (overlap <= 0) return;
    double nx = dx / d;
    double ny = dy / d;
    double vn = (vx - other.vx) * nx + (vy - other.vy) * ny;
    double f = -kn * overlap - eta * vn;
    fx += f * nx;
    fy += f * ny;
    other.fx -= f * nx;
    other.fy -= f * ny;
}

// Eq. (1) at a wall; the normal goes from the disc to the wall.
void Particle::push(double overlap, double nx, double ny, double kn, double eta) {
    if (overlap <= 0) return;
    double vn = vx * nx + vy * ny;
    double f = -kn * overlap - eta * vn;
    fx += f * nx;
    fy += f * ny;
}

void Particle::touchWalls(double side, double kn, double eta) {
    push(r - x, -1, 0, kn, eta);
    push(x + r - side, 1, 0, kn, eta);
    push(r - y, 0, -1, kn, eta);
    push(y + r - side, 0, 1, kn, eta);
}

// Eq. (3): first the velocity, then the position with the new velocity.
void Particle::move(double dt) {
    vx += fx / m * dt;
    vy += fy / m * dt;
    x += vx * dt;
    y += vy * dt;
}
