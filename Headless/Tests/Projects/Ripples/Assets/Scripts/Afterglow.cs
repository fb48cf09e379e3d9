using UnityEngine;

namespace Ripples
{
    /// <summary>A static that shows in the second play of a process, where it was asked for.</summary>
    public static class Afterglow
    {
        static bool isOn;
        static int plays;

        public static void TurnOn() => isOn = true;

        [RuntimeInitializeOnLoadMethod]
        static void Glow()
        {
            if (isOn && plays++ > 0) Camera.main.backgroundColor = Color.red;
        }
    }
}
