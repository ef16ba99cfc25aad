// Depth only: there is nothing to compute.
void main() {}
