/* C knows nothing of the headers. */
int plain(void) { return 0; }
