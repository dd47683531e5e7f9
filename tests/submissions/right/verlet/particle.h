#ifndef PARTICLE_H
#define PARTICLE_H

struct Vec {
    double x, y;
};

Vec operator+(Vec a, Vec b);
Vec operator-(Vec a, Vec b);
Vec operator*(double s, Vec a);
double length(Vec a);

struct Particle {
    Vec pos;
    Vec vel;
    Vec force;
    double radius;
    double mass;
};

// Force of the spring on a because of b.
Vec springForce(const Particle &a, const Particle &b, double kn);
// Force of the four walls on a.
Vec wallForce(const Particle &a, double side, double kn);

#endif
