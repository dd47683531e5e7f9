#include <fstream>
#include <string>

int main() {
    std::string million(1000000, '1');
    std::ofstream out("out.txt");
    for (int i = 0; i < 1000 && out; i++) out << million;
    return 0;
}
