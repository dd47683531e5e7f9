#ifndef PARTICLE_H
#define PARTICLE_H

#define MAX_PARTICLES 2000

struct particle {
    double x, y;
    double vx, vy;
    double ax, ay;
};

extern struct particle p[MAX_PARTICLES];
extern int n;

void accelerations(void);
void move(double dt);

#endif
