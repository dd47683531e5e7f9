#include "particle.h"
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>
using namespace std;
int main(int argc, char** argv) {
  srand(argc > 1 ? atoi(argv[1]) : time(0));
  place();
  const double dt = M_PI * sqrt(M / KN) / 50;
  long step = 0;
  while (true) {
    if (step % 100 == 0) {
      ofstream out("out.txt");
      for (int i = 0; i < N; i++) out << x[i] << " " << y[i] << " " << R << endl;
      out.close();
    }
    forces();
    move(dt);
    step++;
  }
}
