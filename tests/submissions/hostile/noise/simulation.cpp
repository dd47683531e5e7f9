#include <cstdlib>
#include <fstream>
#include <unistd.h>

int main() {
    for (int frame = 0; frame < 400; frame++) {
        std::ofstream out("out.txt", std::ios::binary);
        for (int i = 0; i < 10000; i++) out.put(rand() % 256);
        out.close();
        usleep(1000);
    }
    return 0;
}
