using UnityEngine;
using UnityEngine.Scripting;

// Nothing names this assembly: a stripped build would leave it out.
[assembly: AlwaysLinkAssembly]

namespace SphFluid
{
    /// <summary>Adds the thesis's method, corrected and as printed, to the methods of the package.</summary>
    internal static class ThesisRegistration
    {
        /// <summary>Adds them; again, it changes nothing.</summary>
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        public static void Register()
        {
            FluidMethods.Register(new ThesisMethod(FluidMethodKind.Thesis));
            FluidMethods.Register(new ThesisMethod(FluidMethodKind.ThesisPrinted));
        }
    }
}
