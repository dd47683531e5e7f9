/* Runs until somebody stops it, unless a number of frames is given. */
#include "particle.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static double between(double a, double b) {
    return a + (b - a) * rand() / RAND_MAX;
}

static int touches(int i) {
    for (int j = 0; j < i; j++) {
        if (hypot(p[i].x - p[j].x, p[i].y - p[j].y) <= 0.001) return 1;
    }
    return 0;
}

static void print_frame(void) {
    FILE *f = fopen("out.txt", "w");
    if (f == NULL) exit(1);
    for (int i = 0; i < n; i++) fprintf(f, "%f %f %f\n", p[i].x, p[i].y, 0.0005);
    fclose(f);
}

int main(int argc, char **argv) {
    int seed = 1;
    long frames = 0;
    if (argc > 1) n = atoi(argv[1]);
    if (argc > 2) seed = atoi(argv[2]);
    if (argc > 3) frames = atol(argv[3]);
    if (n > MAX_PARTICLES) n = MAX_PARTICLES;

    srand(seed);
    for (int i = 0; i < n; i++) {
        do {
            p[i].x = between(0.0005, 0.0395);
            p[i].y = between(0.0005, 0.0395);
        } while (touches(i));
        p[i].vx = between(-0.5, 0.5);
        p[i].vy = between(-0.5, 0.5);
    }

    double dt = 3.14159265 * sqrt(0.001 / 50000) / 50;
    for (long frame = 1;; frame++) {
        print_frame();
        if (frame == frames) break;
        for (int k = 0; k < 150; k++) {
            accelerations();
            move(dt);
        }
    }
    return 0;
}
