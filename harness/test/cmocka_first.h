/* cmocka.h wants these before it. */
#ifndef LOBE_CMOCKA_FIRST_H
#define LOBE_CMOCKA_FIRST_H
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>
#endif
