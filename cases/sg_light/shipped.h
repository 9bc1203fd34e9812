/* What ships of sg_light: the public functions behind one signature. */
#ifndef LOBE_SG_LIGHT_SHIPPED_H
#define LOBE_SG_LIGHT_SHIPPED_H

typedef struct lobe_sg_shipped {
    const char *tier, *format;
    double (*call)(const double row[5]); /* of the columns of columns.h; q30 with its own exponent, not as Q30 */
} lobe_sg_shipped;

/* The i-th, or NULL past the end. */
const lobe_sg_shipped *lobe_sg_shipped_at(int i);

#endif
