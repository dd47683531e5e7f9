#include "particle.h"
#include <math.h>

struct particle p[MAX_PARTICLES];
int n = 20;

static const double L = 0.04, R = 0.0005, M = 0.001, K = 50000, G = 9.81;

void accelerations(void) {
    for (int i = 0; i < n; i++) {
        p[i].ax = 0;
        p[i].ay = -G;
        if (p[i].x - R < 0) p[i].ax += K / M * (R - p[i].x);
        if (p[i].x + R > L) p[i].ax -= K / M * (p[i].x + R - L);
        if (p[i].y - R < 0) p[i].ay += K / M * (R - p[i].y);
        if (p[i].y + R > L) p[i].ay -= K / M * (p[i].y + R - L);
    }
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < i; j++) {
            double dx = p[i].x - p[j].x;
            double dy = p[i].y - p[j].y;
            if (fabs(dx) > 2 * R || fabs(dy) > 2 * R) continue;
            double d = sqrt(dx * dx + dy * dy);
            if (d > 2 * R) continue;
            double a = K / M * (2 * R - d);
            p[i].ax += a * dx / d;
            p[i].ay += a * dy / d;
            p[j].ax -= a * dx / d;
            p[j].ay -= a * dy / d;
        }
    }
}

void move(double dt) {
    for (int i = 0; i < n; i++) {
        p[i].vx += p[i].ax * dt;
        p[i].vy += p[i].ay * dt;
        p[i].x += p[i].vx * dt;
        p[i].y += p[i].vy * dt;
    }
}
