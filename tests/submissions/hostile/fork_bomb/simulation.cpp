// 4096 processes, if nobody stops it. They end by themselves after half a minute.
#include <unistd.h>

int main() {
    for (int i = 0; i < 12; i++) {
        if (fork() < 0) sleep(1);
    }
    sleep(30);
    return 0;
}
