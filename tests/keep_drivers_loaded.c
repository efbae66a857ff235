// For sanitized builds only: what graphics drivers keep until the end is not taken for a leak of Tyg's. The drivers
// stay loaded, so that the leak report has their names; and these names are told here, in the program: a file of them
// would need a path in LSAN_OPTIONS, where a path with a space cannot be said.
int dlclose(void* library);
int dlclose(void* library) {
  (void)library;
  return 0;
}

// OSMesa 22.3.6 keeps 480 bytes of its own; Mesa's software driver keeps the buffers of a window that freeglut closed.
// freeglut 3.4.0 does not free the data of a mouse event that reaches it after it has closed the event's window.
const char* __lsan_default_suppressions(void);
const char* __lsan_default_suppressions(void) {
  return "leak:libOSMesa\nleak:swrast_dri\nleak:libgallium\nleak:libXi\n";
}

// Where nothing else leaks, standard error stays as it is without sanitizers: tests read it.
const char* __lsan_default_options(void);
const char* __lsan_default_options(void) { return "print_suppressions=0"; }
