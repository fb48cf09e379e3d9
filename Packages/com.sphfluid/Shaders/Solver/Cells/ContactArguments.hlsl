#ifndef SPHFLUID_CONTACT_ARGUMENTS
#define SPHFLUID_CONTACT_ARGUMENTS

RWByteAddressBuffer _ContactArgumentsOut; // groups x, y, z of ResolveContacts, then the number of particles

// Before FindContacts of the same step: no particle, in no group of 1 x 1.
void EmptyContacts(uint id)
{
    if (id < 4u)
    {
        _ContactArgumentsOut.Store(4u * id, id == 1u || id == 2u ? 1u : 0u);
    }
}

#endif
