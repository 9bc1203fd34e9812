#include "digest.h"

uint64_t lobe_digest(uint64_t digest, const void *bytes, size_t length)
{
    const unsigned char *byte = bytes;
    size_t i;
    for (i = 0; i < length; i++)
        digest = (digest ^ byte[i]) * UINT64_C(0x100000001b3);
    return digest;
}
