using UnityEditor;

namespace SphFluid.Editor
{
    /// <summary>Makes the thesis's method known to inspectors and edit mode.</summary>
    internal static class ThesisEditor
    {
        [InitializeOnLoadMethod]
        private static void Register() => ThesisRegistration.Register();
    }
}
