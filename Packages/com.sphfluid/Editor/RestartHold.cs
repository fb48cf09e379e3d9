using System;
using UnityEditor;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Editor
{
    /// <summary>
    /// Lets simulations in play start again once, when the user has let go of a handle or a field, and not with each change on the way
    /// there. Until then they stand still.
    /// </summary>
    internal sealed class RestartHold
    {
        private readonly Object[] simulations;
        private bool holds;

        /// <param name="simulations">The simulations that are edited.</param>
        public RestartHold(Object[] simulations) => this.simulations = simulations;

        /// <summary>A setting was changed by the user.</summary>
        public void Begin()
        {
            if (holds || !IsUnderWay) return;
            Set(true);
            EditorApplication.update += Look;
        }

        /// <summary>The inspector is gone.</summary>
        public void End()
        {
            if (!holds) return;
            EditorApplication.update -= Look;
            Set(false);
        }

        // A mouse button is down on a control, or a text field has the keyboard.
        private static bool IsUnderWay => GUIUtility.hotControl != 0 || EditorGUIUtility.editingTextField;

        private void Look()
        {
            if (!IsUnderWay) End();
        }

        private void Set(bool later)
        {
            holds = later;
            foreach (Object simulation in simulations)
                if (simulation != null) ((FluidSimulation)simulation).StartsLater = later;
        }
    }
}
