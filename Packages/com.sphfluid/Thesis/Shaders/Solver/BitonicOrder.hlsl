#ifndef SPHFLUID_BITONIC_ORDER
#define SPHFLUID_BITONIC_ORDER

// By cell, then by id: the order is unique, so the sort does not depend on how it is carried out.
bool InOrder(uint2 a, uint2 b)
{
    return a.x < b.x || (a.x == b.x && a.y <= b.y);
}

#endif
