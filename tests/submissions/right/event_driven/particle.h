// A hard disc that flies on a parabola between collisions.
#ifndef PARTICLE_H
#define PARTICLE_H

const double NEVER = 1e30;
const double G = 9.81;

struct Particle {
    double x, y, vx, vy, r;

    void fly(double t);
    // Time until it meets the other disc, or NEVER.
    double timeTo(const Particle &other) const;
    // Time until it meets a wall: 0 left, 1 right, 2 floor, 3 ceiling.
    double timeToWall(int wall, double side) const;
};

void collide(Particle &a, Particle &b);
void bounce(Particle &p, int wall);

#endif
