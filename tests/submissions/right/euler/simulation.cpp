// Usage: parSim2D [discs] [seed] [frames, 0 = for ever]
#include "particle.h"
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <random>
#include <thread>
#include <vector>

const double SIDE = 0.04;
const double MASS = 1e-3;
const double RADIUS = 5e-4;
const double G = 9.81;
const double KN = 5e4;
const double ETA = 1.5e-3;
const int NT = 50;
const int STEPS_PER_FRAME = 100;

bool isFree(const std::vector<Particle> &discs, double x, double y) {
    for (const Particle &p : discs) {
        if (std::hypot(p.x - x, p.y - y) < p.r + RADIUS) return false;
    }
    return true;
}

std::vector<Particle> placeDiscs(int n, int seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> inside(RADIUS, SIDE - RADIUS);
    std::vector<Particle> discs;
    while ((int)discs.size() < n) {
        double x = inside(random);
        double y = inside(random);
        if (isFree(discs, x, y)) discs.push_back(Particle(x, y, RADIUS, MASS));
    }
    return discs;
}

void step(std::vector<Particle> &discs, double dt) {
    for (Particle &p : discs) p.startForce(G);
    for (size_t i = 0; i < discs.size(); i++) {
        for (size_t j = i + 1; j < discs.size(); j++) {
            discs[i].touch(discs[j], KN, ETA);
        }
        discs[i].touchWalls(SIDE, KN, ETA);
    }
    for (Particle &p : discs) p.move(dt);
}

void write(const std::vector<Particle> &discs) {
    std::ofstream out("out.txt");
    out.precision(9);
    for (const Particle &p : discs) {
        out << p.x << " " << p.y << " " << p.r << "\n";
    }
}

int main(int argc, char *argv[]) {
    int n = argc > 1 ? atoi(argv[1]) : 20;
    int seed = argc > 2 ? atoi(argv[2]) : 1;
    int frames = argc > 3 ? atoi(argv[3]) : 400;

    double dt = M_PI * sqrt(MASS / KN) / NT;  // Eq. (2)
    std::vector<Particle> discs = placeDiscs(n, seed);
    write(discs);
    for (int frame = 1; frame < frames || frames == 0; frame++) {
        for (int k = 0; k < STEPS_PER_FRAME; k++) step(discs, dt);
        write(discs);
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return 0;
}
