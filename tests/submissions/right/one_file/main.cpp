// Discs in a box, all in one file.
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iomanip>
#include <random>
#include <unistd.h>
#include <vector>
using namespace std;

double l = 0.04, r = 1e-4, m = 1e-3, g = 9.81, kn = 5e4, eta = 1.5e-3;

struct Disc {
    double x, y, vx, vy, fx, fy;
};

vector<Disc> d;

void forces() {
    for (Disc &a : d) {
        a.fx = 0;
        a.fy = -m * g;
        // the wall is a half-plane: a disc beyond it is still pushed back
        if (a.x < r) a.fx += kn * (r - a.x) - eta * a.vx;
        if (a.x > l - r) a.fx -= kn * (a.x - l + r) + eta * a.vx;
        if (a.y < r) a.fy += kn * (r - a.y) - eta * a.vy;
        if (a.y > l - r) a.fy -= kn * (a.y - l + r) + eta * a.vy;
    }
    for (size_t i = 0; i < d.size(); i++) {
        for (size_t j = i + 1; j < d.size(); j++) {
            double nx = d[j].x - d[i].x;
            double ny = d[j].y - d[i].y;
            if (fabs(nx) > 2 * r || fabs(ny) > 2 * r) continue;
            double dist = hypot(nx, ny);
            if (dist > 2 * r) continue;
            nx /= dist;
            ny /= dist;
            double vrn = (d[i].vx - d[j].vx) * nx + (d[i].vy - d[j].vy) * ny;
            double f = kn * (2 * r - dist) + eta * vrn;
            d[i].fx -= f * nx;
            d[i].fy -= f * ny;
            d[j].fx += f * nx;
            d[j].fy += f * ny;
        }
    }
}

int main(int argc, char *argv[]) {
    size_t n = argc > 1 ? atoi(argv[1]) : 20;
    int seed = argc > 2 ? atoi(argv[2]) : 1;
    int frames = argc > 3 ? atoi(argv[3]) : 400;

    mt19937_64 rng(seed);
    uniform_real_distribution<double> where(r, l - r), how_fast(-0.8, 0.8);
    while (d.size() < n) {
        Disc a = {where(rng), where(rng), how_fast(rng), how_fast(rng), 0, 0};
        bool free = true;
        for (Disc &b : d) free = free && hypot(a.x - b.x, a.y - b.y) > 2 * r;
        if (free) d.push_back(a);
    }

    double dt = M_PI * sqrt(m / kn) / 30;
    for (int frame = 0; frame < frames || frames == 0; frame++) {
        ofstream out("out.txt");
        out << scientific << setprecision(8);
        for (Disc &a : d) out << a.x << " " << a.y << " " << r << "\n";
        out.close();
        usleep(1000);
        for (int k = 0; k < 60; k++) {
            forces();
            for (Disc &a : d) {
                a.vx += a.fx / m * dt;
                a.vy += a.fy / m * dt;
                a.x += a.vx * dt;
                a.y += a.vy * dt;
            }
        }
    }
}
