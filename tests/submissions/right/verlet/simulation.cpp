#include "particle.h"
#include <cmath>
#include <fstream>
#include <iostream>
#include <random>
#include <string>
#include <unistd.h>
#include <vector>
using namespace std;

const double side = 0.04;
const double radius = 1e-4;
const double mass = 1e-3;
const double kn = 5e4;
const Vec gravity = {0, -9.81};
const double speed = 0.7;
const int stepsPerFrame = 100;

vector<Particle> discs;

void place(int n, int seed) {
    mt19937 gen(seed);
    uniform_real_distribution<double> coordinate(radius, side - radius);
    uniform_real_distribution<double> component(-speed, speed);
    for (int i = 0; i < n; i++) {
        Particle p;
        bool overlaps;
        do {
            p.pos = {coordinate(gen), coordinate(gen)};
            overlaps = false;
            for (int j = 0; j < i; j++) {
                if (length(p.pos - discs[j].pos) < 2 * radius) overlaps = true;
            }
        } while (overlaps);
        p.vel = {component(gen), component(gen)};
        p.force = {0, 0};
        p.radius = radius;
        p.mass = mass;
        discs.push_back(p);
    }
}

void computeForces() {
    for (Particle &p : discs) {
        p.force = p.mass * gravity + wallForce(p, side, kn);
    }
    for (size_t i = 0; i < discs.size(); i++) {
        for (size_t j = 0; j < i; j++) {
            if (fabs(discs[i].pos.x - discs[j].pos.x) > 2 * radius) continue;
            Vec f = springForce(discs[i], discs[j], kn);
            discs[i].force = discs[i].force + f;
            discs[j].force = discs[j].force - f;
        }
    }
}

// Velocity Verlet: half a kick, a drift, new forces, the other half.
void advance(double dt) {
    for (Particle &p : discs) {
        p.vel = p.vel + (0.5 * dt / p.mass) * p.force;
        p.pos = p.pos + dt * p.vel;
    }
    computeForces();
    for (Particle &p : discs) {
        p.vel = p.vel + (0.5 * dt / p.mass) * p.force;
    }
}

void save() {
    ofstream file("out.txt");
    for (size_t i = 0; i < discs.size(); i++) {
        file << discs[i].pos.x << " " << discs[i].pos.y << " " << discs[i].radius << endl;
    }
    file.close();
}

int main(int argc, char **argv) {
    int n = 20, seed = 1, frames = 400;
    if (argc > 1) n = stoi(argv[1]);
    if (argc > 2) seed = stoi(argv[2]);
    if (argc > 3) frames = stoi(argv[3]);

    const double dt = M_PI * sqrt(mass / kn) / 50;
    place(n, seed);
    computeForces();
    int frame = 0;
    while (true) {
        save();
        frame++;
        if (frame == frames) break;
        usleep(2000);
        for (int k = 0; k < stepsPerFrame; k++) advance(dt);
    }
    cout << "done, " << frame << " frames" << endl;
    return 0;
}
