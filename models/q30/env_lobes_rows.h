/* The coefficients of the fans of taps as integers: a row a quantity, in the order in which the kernels of
 * ../env_lobesN.h and ../env_lobes_sg.h name them, Q20. The sum of a row's magnitudes is under 2047, which
 * test_env_lobes.c holds: so no sum of products with numbers in [0, 1] leaves 32 bits. */
#ifndef LOBE_Q30_ENV_LOBES_ROWS_H
#define LOBE_Q30_ENV_LOBES_ROWS_H
#include "../../core/dialect.h"
#include "../../core/q30_scaled.h"

enum { LOBE_ENV_COLUMNS = 12, LOBE_ENV_BITS = 20 };

#define LOBE_ENV_Q(x) LOBE_Q_CONSTANT(x, LOBE_ENV_BITS)
#define LOBE_ENV_ROW(P, a, b, c, d, e, f, g, h, i, j, k, l)                                                            \
    {                                                                                                                  \
        LOBE_ENV_Q(P##a), LOBE_ENV_Q(P##b), LOBE_ENV_Q(P##c), LOBE_ENV_Q(P##d), LOBE_ENV_Q(P##e), LOBE_ENV_Q(P##f),    \
            LOBE_ENV_Q(P##g), LOBE_ENV_Q(P##h), LOBE_ENV_Q(P##i), LOBE_ENV_Q(P##j), LOBE_ENV_Q(P##k), LOBE_ENV_Q(P##l) \
    }

enum { LOBE_ENV_LOBES1_ROW_COUNT = 2 };
#define LOBE_ENV_LOBES1_ROWS                                                                                           \
    {                                                                                                                  \
        LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES1_C, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11),                                   \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES1_C, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23)                      \
    }
enum { LOBE_ENV_LOBES2_ROW_COUNT = 5 };
#define LOBE_ENV_LOBES2_ROWS                                                                                           \
    {                                                                                                                  \
        LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES2_C, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11),                                   \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES2_C, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23),                     \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES2_C, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35),                     \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES2_C, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47),                     \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES2_C, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59)                      \
    }
enum { LOBE_ENV_LOBES4_ROW_COUNT = 11 };
#define LOBE_ENV_LOBES4_ROWS                                                                                           \
    {                                                                                                                  \
        LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES4_C, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11),                                   \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES4_C, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23),                     \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES4_C, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35),                     \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES4_C, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47),                     \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES4_C, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59),                     \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES4_C, 60, 61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 71),                     \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES4_C, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83),                     \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES4_C, 84, 85, 86, 87, 88, 89, 90, 91, 92, 93, 94, 95),                     \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES4_C, 96, 97, 98, 99, 100, 101, 102, 103, 104, 105, 106, 107),             \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES4_C, 108, 109, 110, 111, 112, 113, 114, 115, 116, 117, 118, 119),         \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES4_C, 120, 121, 122, 123, 124, 125, 126, 127, 128, 129, 130, 131)          \
    }
enum { LOBE_ENV_LOBES8_ROW_COUNT = 23 };
#define LOBE_ENV_LOBES8_ROWS                                                                                           \
    {                                                                                                                  \
        LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES8_C, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11),                                   \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES8_C, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23),                     \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES8_C, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35),                     \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES8_C, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47),                     \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES8_C, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59),                     \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES8_C, 60, 61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 71),                     \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES8_C, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83),                     \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES8_C, 84, 85, 86, 87, 88, 89, 90, 91, 92, 93, 94, 95),                     \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES8_C, 96, 97, 98, 99, 100, 101, 102, 103, 104, 105, 106, 107),             \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES8_C, 108, 109, 110, 111, 112, 113, 114, 115, 116, 117, 118, 119),         \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES8_C, 120, 121, 122, 123, 124, 125, 126, 127, 128, 129, 130, 131),         \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES8_C, 132, 133, 134, 135, 136, 137, 138, 139, 140, 141, 142, 143),         \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES8_C, 144, 145, 146, 147, 148, 149, 150, 151, 152, 153, 154, 155),         \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES8_C, 156, 157, 158, 159, 160, 161, 162, 163, 164, 165, 166, 167),         \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES8_C, 168, 169, 170, 171, 172, 173, 174, 175, 176, 177, 178, 179),         \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES8_C, 180, 181, 182, 183, 184, 185, 186, 187, 188, 189, 190, 191),         \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES8_C, 192, 193, 194, 195, 196, 197, 198, 199, 200, 201, 202, 203),         \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES8_C, 204, 205, 206, 207, 208, 209, 210, 211, 212, 213, 214, 215),         \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES8_C, 216, 217, 218, 219, 220, 221, 222, 223, 224, 225, 226, 227),         \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES8_C, 228, 229, 230, 231, 232, 233, 234, 235, 236, 237, 238, 239),         \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES8_C, 240, 241, 242, 243, 244, 245, 246, 247, 248, 249, 250, 251),         \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES8_C, 252, 253, 254, 255, 256, 257, 258, 259, 260, 261, 262, 263),         \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_LOBES8_C, 264, 265, 266, 267, 268, 269, 270, 271, 272, 273, 274, 275)          \
    }
enum { LOBE_ENV_LOBES_SG1_ROW_COUNT = 2 };
#define LOBE_ENV_LOBES_SG1_ROWS                                                                                        \
    {                                                                                                                  \
        LOBE_ENV_ROW(LOBE_ENV_LOBES_SG_LOBES1_C, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11),                                \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_SG_LOBES1_C, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23)                   \
    }
enum { LOBE_ENV_LOBES_SG2_ROW_COUNT = 5 };
#define LOBE_ENV_LOBES_SG2_ROWS                                                                                        \
    {                                                                                                                  \
        LOBE_ENV_ROW(LOBE_ENV_LOBES_SG_LOBES2_C, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11),                                \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_SG_LOBES2_C, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23),                  \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_SG_LOBES2_C, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35),                  \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_SG_LOBES2_C, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47),                  \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_SG_LOBES2_C, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59)                   \
    }
enum { LOBE_ENV_LOBES_SG4_ROW_COUNT = 8 };
#define LOBE_ENV_LOBES_SG4_ROWS                                                                                        \
    {                                                                                                                  \
        LOBE_ENV_ROW(LOBE_ENV_LOBES_SG_LOBES4_C, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11),                                \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_SG_LOBES4_C, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23),                  \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_SG_LOBES4_C, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35),                  \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_SG_LOBES4_C, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47),                  \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_SG_LOBES4_C, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59),                  \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_SG_LOBES4_C, 60, 61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 71),                  \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_SG_LOBES4_C, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83),                  \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_SG_LOBES4_C, 84, 85, 86, 87, 88, 89, 90, 91, 92, 93, 94, 95)                   \
    }
enum { LOBE_ENV_LOBES_SG8_ROW_COUNT = 8 };
#define LOBE_ENV_LOBES_SG8_ROWS                                                                                        \
    {                                                                                                                  \
        LOBE_ENV_ROW(LOBE_ENV_LOBES_SG_LOBES8_C, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11),                                \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_SG_LOBES8_C, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21, 22, 23),                  \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_SG_LOBES8_C, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35),                  \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_SG_LOBES8_C, 36, 37, 38, 39, 40, 41, 42, 43, 44, 45, 46, 47),                  \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_SG_LOBES8_C, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59),                  \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_SG_LOBES8_C, 60, 61, 62, 63, 64, 65, 66, 67, 68, 69, 70, 71),                  \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_SG_LOBES8_C, 72, 73, 74, 75, 76, 77, 78, 79, 80, 81, 82, 83),                  \
            LOBE_ENV_ROW(LOBE_ENV_LOBES_SG_LOBES8_C, 84, 85, 86, 87, 88, 89, 90, 91, 92, 93, 94, 95)                   \
    }

#endif
