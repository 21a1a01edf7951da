/* A library that has the right name and none of the functions. */
int sphereview_fake_driver(void) { return 0; }
