// Writes only depth, so there is nothing to compute.
void main() {}
