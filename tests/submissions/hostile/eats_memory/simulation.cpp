#include <cstring>
#include <cstdlib>
#include <unistd.h>

int main() {
    const size_t gigabyte = 1 << 30;
    for (int i = 0; i < 16; i++) {
        char *p = (char *)malloc(gigabyte);
        if (p == NULL) abort();
        memset(p, i, gigabyte);
    }
    sleep(30);
    return 0;
}
