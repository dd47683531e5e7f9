// Adds every frame to out.txt, with a blank line after it.
#include "particle.h"
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <random>

#define SIDE 0.04
#define G 9.81
#define KN 5.0e4
#define ETA 0.5

void gravity(Particles &p) {
    for (int i = 0; i < p.n; i++) {
        p.fx[i] = 0;
        p.fy[i] = -G * p.mass;
    }
}

void contacts(Particles &p) {
    for (int i = 0; i < p.n; i++) {
        for (int j = i + 1; j < p.n; j++) {
            double dx = p.x[i] - p.x[j];
            double dy = p.y[i] - p.y[j];
            double d2 = dx * dx + dy * dy;
            double sum = 2 * p.radius;
            if (d2 >= sum * sum) continue;
            double d = sqrt(d2);
            double nx = dx / d;
            double ny = dy / d;
            double vn = (p.vx[i] - p.vx[j]) * nx + (p.vy[i] - p.vy[j]) * ny;
            double f = KN * (sum - d) - ETA * vn;
            p.fx[i] += f * nx;
            p.fy[i] += f * ny;
            p.fx[j] -= f * nx;
            p.fy[j] -= f * ny;
        }
    }
}

void walls(Particles &p) {
    double r = p.radius;
    for (int i = 0; i < p.n; i++) {
        if (p.x[i] < r) p.fx[i] += KN * (r - p.x[i]) - ETA * p.vx[i];
        if (p.x[i] > SIDE - r) p.fx[i] += KN * (SIDE - r - p.x[i]) - ETA * p.vx[i];
        if (p.y[i] < r) p.fy[i] += KN * (r - p.y[i]) - ETA * p.vy[i];
        if (p.y[i] > SIDE - r) p.fy[i] += KN * (SIDE - r - p.y[i]) - ETA * p.vy[i];
    }
}

void euler(Particles &p, double dt) {
    for (int i = 0; i < p.n; i++) {
        p.vx[i] += p.fx[i] / p.mass * dt;
        p.vy[i] += p.fy[i] / p.mass * dt;
        p.x[i] += p.vx[i] * dt;
        p.y[i] += p.vy[i] * dt;
    }
}

int main(int argc, char *argv[]) {
    int n = 20, seed = 1, frames = 400;
    if (argc >= 2) n = atoi(argv[1]);
    if (argc >= 3) seed = atoi(argv[2]);
    if (argc >= 4) frames = atoi(argv[3]);

    Particles p(n, 5e-4, 1e-3);
    std::mt19937 gen(seed);
    std::uniform_real_distribution<double> u(0, 1);
    for (int i = 0; i < n; i++) {
        do {
            p.x[i] = p.radius + u(gen) * (SIDE - 2 * p.radius);
            p.y[i] = p.radius + u(gen) * (SIDE - 2 * p.radius);
        } while (p.overlaps(i));
        double angle = 2 * M_PI * u(gen);
        p.vx[i] = 0.6 * cos(angle);
        p.vy[i] = 0.6 * sin(angle);
    }

    double dt = M_PI * sqrt(p.mass / KN) / 40;
    std::ofstream out("out.txt");
    out.precision(8);
    for (int frame = 0; frame < frames || frames == 0; frame++) {
        for (int i = 0; i < n; i++) {
            out << p.x[i] << "\t" << p.y[i] << "\t" << p.radius << "\n";
        }
        out << "\n";
        for (int k = 0; k < 80; k++) {
            gravity(p);
            contacts(p);
            walls(p);
            euler(p, dt);
        }
    }
    return 0;
}
