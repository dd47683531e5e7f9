#include "particle.h"
#include <cmath>

void Particle::fly(double t) {
    x += vx * t;
    y += vy * t - 0.5 * G * t * t;
    vy -= G * t;
}

// Both fall alike, so seen from one the other moves on a straight line.
double Particle::timeTo(const Particle &other) const {
    double dx = other.x - x, dy = other.y - y;
    double dvx = other.vx - vx, dvy = other.vy - vy;
    double b = dx * dvx + dy * dvy;
    if (b >= 0) return NEVER;  // they go apart
    double a = dvx * dvx + dvy * dvy;
    double c = dx * dx + dy * dy - (r + other.r) * (r + other.r);
    double disc = b * b - a * c;
    if (disc < 0) return NEVER;
    double t = (-b - std::sqrt(disc)) / a;
    return t > 0 ? t : 0;
}

double Particle::timeToWall(int wall, double side) const {
    double t = NEVER;
    if (wall == 0 && vx < 0) t = (r - x) / vx;
    if (wall == 1 && vx > 0) t = (side - r - x) / vx;
    if (wall == 2) t = (vy + std::sqrt(vy * vy + 2 * G * std::fmax(y - r, 0))) / G;
    if (wall == 3 && vy > 0) {
        double room = side - r - y;
        double disc = vy * vy - 2 * G * room;
        if (disc > 0) t = (vy - std::sqrt(disc)) / G;
    }
    return t > 0 ? t : 0;
}

// Equal masses: they swap the velocities along the line of centres.
void collide(Particle &a, Particle &b) {
    double nx = b.x - a.x, ny = b.y - a.y;
    double d = std::sqrt(nx * nx + ny * ny);
    nx /= d;
    ny /= d;
    double vn = (b.vx - a.vx) * nx + (b.vy - a.vy) * ny;
    a.vx += vn * nx;
    a.vy += vn * ny;
    b.vx -= vn * nx;
    b.vy -= vn * ny;
}

void bounce(Particle &p, int wall) {
    if (wall == 0) p.vx = std::fabs(p.vx);
    if (wall == 1) p.vx = -std::fabs(p.vx);
    if (wall == 2) p.vy = std::fabs(p.vy);
    if (wall == 3) p.vy = -std::fabs(p.vy);
}
