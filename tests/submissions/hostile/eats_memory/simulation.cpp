#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <unistd.h>

int main() {
    const size_t gigabyte = 1 << 30;
    for (int i = 0; i < 16; i++) {
        char *p = (char *)malloc(gigabyte);
        if (p == NULL) abort();
        memset(p, i + 1, gigabyte);
        printf("%d GB, %d\n", i + 1, p[rand() % gigabyte]);
        fflush(stdout);
    }
    sleep(30);
    return 0;
}
