#include <fstream>
#include <unistd.h>

int main() {
    for (int frame = 0; frame < 400; frame++) {
        std::ofstream out("out.txt");
        out.close();
        usleep(1000);
    }
    return 0;
}
