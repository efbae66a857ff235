// For sanitized builds only: graphics drivers stay loaded, so that what they keep until the end still has their name in
// the leak report and tests/lsan.supp can tell it from what Tyg keeps.
int dlclose(void* library);
int dlclose(void* library) {
  (void)library;
  return 0;
}
