using System.Reflection;

namespace SphFluid.Tests
{
    /// <summary>Calls of the thesis's assembly with arguments that they should not get.</summary>
    public sealed class ThesisArgumentContractTests : ArgumentContract
    {
        protected override Assembly Package => typeof(ThesisRules).Assembly;

        protected override (string call, string reason)[] Exempt => new[]
        {
            (@"^ThesisRules\.", "is checked where a liquid takes the settings"),
            (@"\.WithSoundSpeed", "is checked where a liquid takes the settings"),
        };
    }
}
