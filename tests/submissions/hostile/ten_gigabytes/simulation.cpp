#include <fstream>
#include <string>

int main() {
    std::string million;
    while (million.size() < 1000000) million += "0.01 0.02 0.0005\n";
    std::ofstream out("out.txt");
    for (int i = 0; i < 10000 && out; i++) out << million;
    return 0;
}
