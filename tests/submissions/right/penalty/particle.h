#ifndef PARTICLE_H
#define PARTICLE_H

// What the discs are made of.
struct Material {
    double kn;        // stiffness of the spring, N/m
    double eta_pair;  // dashpot between two discs, kg/s
    double eta_wall;  // dashpot at a wall, kg/s
};

class Particle {
public:
    Particle(double px, double py, double vx, double vy, double radius, double mass);
    double getX() const { return p[0]; }
    double getY() const { return p[1]; }
    double getRadius() const { return radius; }
    void resetForce(const double gravity[2]);
    void addForce(const double f[2], double sign);
    bool contactForce(const Particle &other, const Material &mat, double f[2]) const;
    void addWalls(double side, const Material &mat);
    void integrate(double dt);

private:
    double p[2], v[2], F[2];
    double radius, mass;
};

// Damping coefficient that gives the restitution e to the mass m.
double dampingFor(double e, double kn, double m);

#endif
