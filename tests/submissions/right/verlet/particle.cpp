#include "particle.h"
#include <cmath>

Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y}; }
Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y}; }
Vec operator*(double s, Vec a) { return {s * a.x, s * a.y}; }
double length(Vec a) { return std::sqrt(a.x * a.x + a.y * a.y); }

Vec springForce(const Particle &a, const Particle &b, double kn) {
    Vec d = b.pos - a.pos;
    double dist = length(d);
    double delta = a.radius + b.radius - dist;
    if (delta <= 0) return {0, 0};
    Vec normal = (1 / dist) * d;
    return -kn * delta * normal;
}

Vec wallForce(const Particle &a, double side, double kn) {
    Vec f = {0, 0};
    double left = a.radius - a.pos.x;
    double right = a.pos.x + a.radius - side;
    double bottom = a.radius - a.pos.y;
    double top = a.pos.y + a.radius - side;
    if (left > 0) f.x += kn * left;
    if (right > 0) f.x -= kn * right;
    if (bottom > 0) f.y += kn * bottom;
    if (top > 0) f.y -= kn * top;
    return f;
}
