#ifndef SPHFLUID_NEIGHBOUR_LIST
#define SPHFLUID_NEIGHBOUR_LIST

// Neighbours that the density pass found, two a word, in a column for each particle. 32 particles lie side by side: their n-th words
// are one line of memory. Worked example: particle 33, the second of its 32, length 72, 37 words: word 0 stands at 37 * 32 + 1, word 1 32
// behind.
//
// The particles are sorted by cells and found in that order, so most follow the one before closely. A list is a few runs of such:
//   head    how far the first is from the last of the run before, in the list's first run from the particle itself, with sign in bits 0
//           to 23; LIST_HIDES; LIST_GOES_ON, another run follows; and its pairs in bits 26 to 31
//   hidden  with LIST_HIDES: of this pair and the 15 that come next, in this run or others, two bits each: who is behind a face, as things
//           stand; every density pass notes it anew
//   pairs   how far each is from the one before, the first of the pair in the lower 16 bits; an upper 0: there is no second
// Worked example, particle 500 with neighbours 480, 481, 502 and 90,000: a run of 480 and 481, 502 and nobody, and one of 90,000:
//   -20 & 0xffffff | LIST_GOES_ON | 2 * LIST_PAIR,  0 | 1 << 16,  21,  89498 | LIST_PAIR,  0.
#define LIST_LANES 32u // mirrored by NeighbourList.Lanes
#define LIST_HIDES 0x1000000u
#define LIST_GOES_ON 0x2000000u
#define LIST_PAIR 0x4000000u
#define LIST_PAIRS 63u // of a run at most

StructuredBuffer<uint> _Neighbours;
RWStructuredBuffer<uint> _NeighboursOut;

// A kernel that lists reads where it writes.
#if defined(WRITES_LISTS)
#define LISTS _NeighboursOut
#else
#define LISTS _Neighbours
#endif

// Behind the columns of all particles stand numbers of each.
uint _NeighbourCountsBegin; // how many neighbours it has, listed or not; more than _ListLength: not listed
uint _DensitiesBegin;       // kg/m^3, as bits
uint _WallSlotBegin;        // 0: no walls; else 1 + their place in _NearWalls
uint _WallBodiesBegin;      // of each plane of its walls the number of a body that the liquid moves, in BODY_NUMBER_BITS; 0: no such body

uint _ListLength; // more neighbours than this are not listed: who has them searches again; all do, where it is 0

#define LIST_WORDS (_ListLength / 2u + 1u) // of a column: one run, if it is full

uint ListPlace(uint id, uint n)
{
    return (id / LIST_LANES * LIST_WORDS + n) * LIST_LANES + id % LIST_LANES;
}

struct ListRun
{
    uint Head;   // less the pairs that are taken
    uint At;     // of the next word
    uint Last;   // neighbour
    uint Hidden; // bits of the next pair, or neighbour, and those behind it
    uint Half;   // where neighbours are taken one by one: the lowest bit of the next
};

// Before the first run of a particle's list. count: its neighbours, 0 of one that is not listed.
ListRun BeforeRuns(uint id, uint count)
{
    ListRun run = (ListRun)0;
    run.Head = count > 0u ? LIST_GOES_ON : 0u;
    run.At = ListPlace(id, 0u);
    run.Last = id;
    return run;
}

void OpenRun(inout ListRun run)
{
    run.Head = LISTS[run.At];
    run.Last += asuint(asint(run.Head << 8u) >> 8);
    run.At += LIST_LANES;
    const bool hides = (run.Head & LIST_HIDES) != 0u;
#if defined(FLUID_MESH_WALLS) || defined(READS_HIDDEN)
    run.Hidden = hides ? LISTS[run.At] : run.Hidden;
#endif
    run.At += hides ? LIST_LANES : 0u;
}

#define FOR_EACH_RUN(id, count, run) \
    for (ListRun run = BeforeRuns(id, count); (run.Head & LIST_GOES_ON) != 0u; ) \
        for (OpenRun(run); run.Head >= LIST_PAIR; )

struct ListPair
{
    uint First;
    uint Second;
    bool SeesFirst;
    bool SeesSecond; // else it may be the first again
};

// In FOR_EACH_RUN: two neighbours, whose loads do not wait for each other.
ListPair NextPair(inout ListRun run)
{
    const uint word = LISTS[run.At];
    ListPair pair;
    pair.First = run.Last + (word & 0xffffu);
    pair.Second = pair.First + (word >> 16u);
    pair.SeesFirst = true;
    pair.SeesSecond = word > 0xffffu;
#if defined(FLUID_MESH_WALLS)
    pair.SeesFirst = (run.Hidden & 1u) == 0u;
    pair.SeesSecond = pair.SeesSecond && (run.Hidden & 2u) == 0u;
    run.Hidden >>= 2u;
#endif
    run.Last = pair.Second;
    run.At += LIST_LANES;
    run.Head -= LIST_PAIR;
    return pair;
}

// In FOR_EACH_RUN: one neighbour, where a turn is rare or long. sees: false for one behind a face, and for none.
uint NextListed(inout ListRun run, out bool sees)
{
    const uint further = (LISTS[run.At] >> run.Half) & 0xffffu;
    sees = run.Half == 0u || further != 0u;
#if defined(FLUID_MESH_WALLS) || defined(READS_HIDDEN)
    sees = sees && (run.Hidden & 1u) == 0u;
    run.Hidden >>= 1u;
#endif
    run.Last += further;
    run.At += run.Half * (LIST_LANES / 16u);
    run.Head -= run.Half * (LIST_PAIR / 16u);
    run.Half ^= 16u;
    return run.Last;
}

// Where it is asked: whether the list of another has a particle, or that has none either. A particle without a list takes others by
// theirs, else pairs that come near after the lists were made would push from one side.
bool IsListedBy(bool isAsked, uint other, uint id)
{
    const uint count = isAsked ? LISTS[_NeighbourCountsBegin + other] : 0u;
    bool isListed = count > _ListLength;
    FOR_EACH_RUN(other, isListed ? 0u : count, run)
    {
        bool sees;
        isListed = NextListed(run, sees) == id || isListed;
        run.Head = isListed ? 0u : run.Head;
    }
    return isListed;
}

// The squared distance of a neighbour, or one beyond any R: who is not seen is neither felt nor counted.
float SeenSquared(bool sees, float distanceSquared)
{
    return sees ? distanceSquared : 1e30;
}

#endif
