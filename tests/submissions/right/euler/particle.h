// A disc in a box, pushed by springs and dashpots.
#ifndef PARTICLE_H
#define PARTICLE_H

class Particle {
public:
    double x, y;    // position, m
    double vx, vy;  // velocity, m/s
    double fx, fy;  // force, N
    double r;       // radius, m
    double m;       // mass, kg

    Particle(double x, double y, double r, double m);

    void startForce(double g);
    void touch(Particle &other, double kn, double eta);
    void touchWalls(double side, double kn, double eta);
    void move(double dt);

private:
    void push(double overlap, double nx, double ny, double kn, double eta);
};

#endif
