using System;

namespace SphFluid
{
    /// <summary>Says of a static that changes why it need not be reset when play begins without a domain reload.</summary>
    internal sealed class OutlivesPlayAttribute : Attribute
    {
        internal OutlivesPlayAttribute(string reason) { }
    }
}
