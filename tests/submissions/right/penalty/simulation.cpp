#include "particle.h"
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <random>
#include <thread>
#include <vector>

int main(int argc, char *argv[]) {
    const int n = argc > 1 ? std::atoi(argv[1]) : 20;
    const int seed = argc > 2 ? std::atoi(argv[2]) : 1;
    const int frames = argc > 3 ? std::atoi(argv[3]) : 400;

    const double side = 0.04, radius = 5e-4, mass = 1e-3, kn = 5e4, e = 0.8;
    const double gravity[2] = {0.0, -9.81};
    const int steps_per_frame = 100;
    const double dt = M_PI * std::sqrt(mass / kn) / 50;

    Material mat;
    mat.kn = kn;
    mat.eta_wall = dampingFor(e, kn, mass);
    mat.eta_pair = dampingFor(e, kn, mass / 2);  // reduced mass

    // random places without overlap, random velocities
    std::vector<Particle> particles;
    std::srand(seed);
    while ((int)particles.size() < n) {
        double x = radius + (side - 2 * radius) * std::rand() / RAND_MAX;
        double y = radius + (side - 2 * radius) * std::rand() / RAND_MAX;
        double vx = -1.0 + 2.0 * std::rand() / RAND_MAX;
        double vy = -1.0 + 2.0 * std::rand() / RAND_MAX;
        bool ok = true;
        for (const Particle &other : particles) {
            if (std::hypot(other.getX() - x, other.getY() - y) <= 2 * radius) ok = false;
        }
        if (ok) particles.push_back(Particle(x, y, vx, vy, radius, mass));
    }

    for (int frame = 0; frames == 0 || frame < frames; frame++) {
        std::ofstream out("out.txt");
        out << std::setprecision(10);
        for (const Particle &p : particles) {
            out << p.getX() << ' ' << p.getY() << ' ' << p.getRadius() << '\n';
        }
        out.close();
        std::this_thread::sleep_for(std::chrono::milliseconds(1));

        for (int k = 0; k < steps_per_frame; k++) {
            for (Particle &p : particles) {
                p.resetForce(gravity);
                p.addWalls(side, mat);
            }
            for (int i = 0; i < n; i++) {
                for (int j = i + 1; j < n; j++) {
                    double f[2];
                    if (particles[i].contactForce(particles[j], mat, f)) {
                        particles[i].addForce(f, 1);
                        particles[j].addForce(f, -1);
                    }
                }
            }
            for (Particle &p : particles) p.integrate(dt);
        }
    }
    return 0;
}
