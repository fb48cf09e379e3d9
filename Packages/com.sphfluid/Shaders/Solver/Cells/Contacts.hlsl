#ifndef SPHFLUID_CONTACTS
#define SPHFLUID_CONTACTS

// What FindContacts leaves in its buffer for ResolveContacts, in bytes: groups x, y, z, and the number of particles; of each where its step
// began and its place. Behind that what GatherWalls leaves for FindContacts: where each particle gathered its walls, and m: no triangle at
// rest is nearer to there; none is said where bodies move.
#define CONTACT_COUNT 12u
#define CONTACT_BYTES 16u

#define GAP_BRIEF 0x80000000u // of the distance: the walls that were gathered there do not hold far away

uint _WallGapBegin;

uint ContactAddress(uint slot)
{
    return 16u + CONTACT_BYTES * slot;
}

uint GapAddress(uint id)
{
    return 4u * _WallGapBegin + 16u * id;
}

#endif
