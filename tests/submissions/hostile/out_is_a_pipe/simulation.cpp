#include <cstdio>
#include <sys/stat.h>
#include <unistd.h>

int main() {
    remove("out.txt");
    if (mkfifo("out.txt", 0644) != 0) return 1;
    sleep(3);
    return 0;
}
