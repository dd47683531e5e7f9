// Event-driven: jump from collision to collision, no time step.
#include "particle.h"
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <thread>
#include <vector>

const double SIDE = 0.04;
const double RADIUS = 5e-4;
const double FRAME = 1e-3;  // s between two frames

struct Event {
    double time;  // when, on the clock of the simulation
    int with;     // a disc, or n + number of the wall
};

std::vector<Particle> discs;
std::vector<Event> next;  // the next event of every disc
double now = 0;

void predict(int i) {
    int n = discs.size();
    next[i] = {NEVER, -1};
    for (int w = 0; w < 4; w++) {
        double t = now + discs[i].timeToWall(w, SIDE);
        if (t < next[i].time) next[i] = {t, n + w};
    }
    for (int j = 0; j < n; j++) {
        if (j == i) continue;
        double t = now + discs[i].timeTo(discs[j]);
        if (t < next[i].time) next[i] = {t, j};
    }
}

void flyAll(double until) {
    for (Particle &p : discs) p.fly(until - now);
    now = until;
}

void runUntil(double end) {
    int n = discs.size();
    while (true) {
        int i = 0;
        for (int k = 1; k < n; k++) {
            if (next[k].time < next[i].time) i = k;
        }
        if (next[i].time > end) break;
        int with = next[i].with;
        flyAll(next[i].time);
        if (with >= n) {
            bounce(discs[i], with - n);
        } else {
            collide(discs[i], discs[with]);
        }
        // What was said of these two is no longer true.
        for (int k = 0; k < n; k++) {
            bool stale = next[k].with == i || (with < n && next[k].with == with);
            if (k == i || k == with || stale) predict(k);
        }
        // They may now be the first that others meet.
        for (int k = 0; k < n; k++) {
            for (int moved : {i, with}) {
                if (moved >= n || moved == k) continue;
                double t = now + discs[k].timeTo(discs[moved]);
                if (t < next[k].time) next[k] = {t, moved};
            }
        }
    }
    flyAll(end);
}

int main(int argc, char *argv[]) {
    int n = argc > 1 ? atoi(argv[1]) : 20;
    int seed = argc > 2 ? atoi(argv[2]) : 1;
    int frames = argc > 3 ? atoi(argv[3]) : 400;

    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(RADIUS, SIDE - RADIUS);
    std::normal_distribution<double> velocity(0, 0.4);
    while ((int)discs.size() < n) {
        Particle p = {place(random), place(random), 0, 0, RADIUS};
        bool free = true;
        for (Particle &q : discs) {
            if (std::hypot(p.x - q.x, p.y - q.y) < 2 * RADIUS) free = false;
        }
        if (!free) continue;
        p.vx = velocity(random);
        p.vy = velocity(random);
        discs.push_back(p);
    }
    next.resize(n);
    for (int i = 0; i < n; i++) predict(i);

    for (int frame = 0; frame < frames || frames == 0; frame++) {
        runUntil(frame * FRAME);
        FILE *out = fopen("out.txt", "w");
        for (Particle &p : discs) fprintf(out, "%.9g %.9g %g\n", p.x, p.y, p.r);
        fclose(out);
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return 0;
}
