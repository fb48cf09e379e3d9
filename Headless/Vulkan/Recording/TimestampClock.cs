namespace Headless.Vulkan;

/// <summary>What the device's timestamps mean.</summary>
/// <param name="NanosecondsPerTick">Length of a tick.</param>
/// <param name="ValidBits">Bits that count; they start again at 0 behind the largest number.</param>
internal readonly record struct TimestampClock(float NanosecondsPerTick, int ValidBits)
{
    /// <summary>Ticks from one timestamp to a later one; 0 where the device took the later one first.</summary>
    public ulong Between(ulong begin, ulong end)
    {
        ulong largest = ulong.MaxValue >> (64 - ValidBits);
        ulong ticks = (end - begin) & largest;
        return ticks <= largest / 2 ? ticks : 0;
    }
}
