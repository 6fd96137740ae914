// MPI unloads its modules at the end, before the leak sanitizer looks: it could then name neither them nor the leaks
// that are theirs. Linked into programs built with the address sanitizer, this keeps them.
extern "C" int dlclose(void* /*handle*/) {
  return 0;
}
