using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Turns states that are given in particle spacings from the domain's lower corner into SI and simulation space.</summary>
    internal sealed class SurfaceScale
    {
        /// <summary>dx [m]. Two frames at 60 a second are then 0.65 √(dx/g) apart.</summary>
        public const float Spacing = 0.025f;

        /// <summary>A scale.</summary>
        /// <param name="quick">True: liquid that moves is looked at for a third of the time.</param>
        public SurfaceScale(bool quick = false)
        {
            Quick = quick;
        }

        /// <summary>Whether liquid that moves is looked at for a third of the time.</summary>
        public bool Quick { get; }

        /// <summary>A state without frames: water by the Standard method in a box.</summary>
        /// <param name="domain">Edges of the domain [dx].</param>
        /// <param name="height">Height of the liquid at the start [dx]; moving liquid's time step follows from it.</param>
        public SurfaceState Empty(Vector3 domain, float height = 1f)
        {
            FluidRuleInput input = FluidRuleInput.Water;
            input.DomainSize = Spacing * domain;
            input.Spacing = Spacing;
            input.LiquidHeight = input.LiquidDepth = height * Spacing;
            return new SurfaceState { Settings = FluidRules.Derive(input) };
        }

        /// <summary>A state of one frame whose liquid has a spacing cubed for each particle.</summary>
        /// <param name="domain">Edges of the domain [dx].</param>
        /// <param name="places">Particles from the domain's lower corner [dx].</param>
        public SurfaceState Of(Vector3 domain, IEnumerable<Vector3> places)
        {
            SurfaceState state = Empty(domain);
            Add(state, places);
            state.Volume = state.Frames[0].Length * Math.Pow(Spacing, 3);
            return state;
        }

        /// <summary>Adds a frame.</summary>
        /// <param name="state">The state.</param>
        /// <param name="places">Particles from the domain's lower corner [dx]; they are kept in the domain.</param>
        public static void Add(SurfaceState state, IEnumerable<Vector3> places)
        {
            var positions = new List<Vector3>();
            Vector3 half = 0.5f * state.Settings.DomainSize, inside = 0.9999f * half;
            foreach (Vector3 place in places) positions.Add(Vector3.Max(-inside, Vector3.Min(inside, Spacing * place - half)));
            state.Frames.Add(positions.ToArray());
        }

        /// <summary>Sets where the top of the liquid is measured.</summary>
        /// <param name="state">The state.</param>
        /// <param name="from">Lower bounds in x and z [dx].</param>
        /// <param name="to">Upper bounds in x and z [dx].</param>
        public static void LookAt(SurfaceState state, Vector2 from, Vector2 to)
        {
            Vector3 half = 0.5f * state.Settings.DomainSize;
            state.Top = Rect.MinMaxRect(from.x * Spacing - half.x, from.y * Spacing - half.z, to.x * Spacing - half.x,
                to.y * Spacing - half.z);
        }

        /// <summary>Height in simulation space [m] of one over the floor [dx].</summary>
        public static double Height(SurfaceState state, double height) => height * Spacing - 0.5 * state.Settings.DomainSize.y;
    }
}
