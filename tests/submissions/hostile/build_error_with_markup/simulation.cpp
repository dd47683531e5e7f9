#error <script>alert("full marks")</script> ]]> Grade :=>> 100 [2J

int main() { return 0; }
