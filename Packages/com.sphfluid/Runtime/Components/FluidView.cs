using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Base of the components that show a simulation. They only read it: after the simulation's own LateUpdate they take its particles as
    /// they then are.
    /// </summary>
    public abstract class FluidView : MonoBehaviour
    {
        [SerializeField, Tooltip("Simulation to draw. Empty: the one on the same GameObject.")]
        private FluidSimulation simulation;

        private FluidSimulation neighbour; // on the same GameObject, where none is assigned
        private FluidShaderSet preparedShaders;
        private bool missingReported;
        private bool failed;
        private int checkedLevel;

        /// <summary>Simulation to draw; where none is assigned, the one on the same GameObject, or null.</summary>
        public FluidSimulation Simulation
        {
            get
            {
                if (simulation != null) return simulation;
                if (neighbour == null) TryGetComponent(out neighbour);
                return neighbour;
            }
            set => simulation = value;
        }

        /// <summary>Tries again after a failure, e.g. once a missing shader has been assigned.</summary>
        protected virtual void OnEnable()
        {
            missingReported = false;
            failed = false;
        }

        /// <summary>Releases what drawing needed.</summary>
        protected virtual void OnDisable() => Forget();

        /// <summary>Draws the simulation, if it runs.</summary>
        protected void LateUpdate() => DrawFrame();

        internal void DrawFrame()
        {
            FluidSimulation drawn = Simulation;
            if (drawn == null)
            {
                ReportMissing();
                DrawNothing();
                return;
            }
            if (failed || drawn.Solver == null || !drawn.isActiveAndEnabled || !drawn.Detail.Drawn)
            {
                DrawNothing();
                return;
            }
            try
            {
                Prepare(drawn.Profile != null ? drawn.Profile.Shaders : null);
                Draw(drawn);
            }
            catch (FluidDeviceException exception)
            {
                failed = true;
                Forget();
                Debug.LogError($"{FluidMessage.Prefix} '{name}': {exception.Message} The liquid is not drawn.", this);
            }
        }

        /// <summary>Makes what drawing needs; called before the first draw and when the shader set changes.</summary>
        /// <param name="shaders">The profile's shader set, never null.</param>
        /// <exception cref="FluidDeviceException">Something is missing in the device or in the shader set.</exception>
        protected abstract void CreateResources(FluidShaderSet shaders);

        /// <summary>Releases what <see cref="CreateResources"/> made; may be called with nothing made.</summary>
        protected abstract void ReleaseResources();

        /// <summary>Draws one frame.</summary>
        /// <param name="drawn">The simulation, with a solver.</param>
        protected abstract void Draw(FluidSimulation drawn);

        /// <summary>A frame without a running simulation: takes away what would otherwise stay visible.</summary>
        protected virtual void DrawNothing()
        {
        }

        /// <summary>Reports, once a level, that cells of a surface are not as large as its level of detail asks.</summary>
        private protected void ReportCells(FluidSimulation drawn, FluidSurfaceOptions made)
        {
            FluidDetail detail = drawn.Detail;
            if (detail.Number == checkedLevel) return;
            checkedLevel = detail.Number;
            float most = made.LargestFactor(drawn.Solver.Settings);
            if (detail.CellFactor <= 1.01f * most) return;
            drawn.Report(new FluidMessage(FluidSeverity.Info, FluidIssue.DetailLimited, this, FormattableString.Invariant(
                $"Level {detail.Number} of detail asks for cells {detail.CellFactor:0.##} times as large; they are {most:0.##} times as ") +
                "large, which the kernel of the surface allows at most.", "Lower Cell Factor, or Cell Size of the surface."));
        }

        private void Prepare(FluidShaderSet shaders)
        {
            if (shaders == null) throw new FluidDeviceException("The simulation's profile has no shader set. Assign one in the profile.");
            if (shaders == preparedShaders) return;
            Forget();
            CreateResources(shaders);
            preparedShaders = shaders;
        }

        private void Forget()
        {
            ReleaseResources();
            preparedShaders = null;
        }

        private void ReportMissing()
        {
            if (missingReported) return;
            missingReported = true;
            Debug.LogWarning(
                $"{FluidMessage.Prefix} '{name}': {GetType().Name} has no simulation to draw. " +
                "Assign one, or put the component on the GameObject of the Fluid Simulation.", this);
        }
    }
}
