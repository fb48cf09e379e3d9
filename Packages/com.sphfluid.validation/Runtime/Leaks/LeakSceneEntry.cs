using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>A scene by name, with the speeds at which it is played. dx = 2 cm, water by rule.</summary>
    internal sealed class LeakSceneEntry
    {
        /// <summary>dx [m].</summary>
        public const float Spacing = 0.02f;

        // Speeds at which a cup is shaken, m/s. The last two take it 2.75 and 3 m a frame; bodies are followed for 64 R = 2.88 m.
        private static readonly double[] ladder = { 1, 2, 5, 10, 20, 40, 80, 120, 150, 165, 180 };

        private readonly Func<double, LeakScene> build;

        private LeakSceneEntry(string name, Func<double, LeakScene> build, params double[] speeds)
        {
            Name = name;
            this.build = build;
            Speeds = speeds.Length == 0 ? new[] { 0.0 } : speeds;
        }

        /// <summary>Name on the command line.</summary>
        public string Name { get; }

        /// <summary>Speeds that the scene is played at, in this order until one fails [m/s].</summary>
        public IReadOnlyList<double> Speeds { get; }

        /// <summary>All.</summary>
        public static IReadOnlyList<LeakSceneEntry> All { get; } = new[]
        {
            new LeakSceneEntry("cup", s => CupScenes.Shaken(s, true), ladder),
            new LeakSceneEntry("open-cup", s => CupScenes.Shaken(s, false), 1, 2, 5, 10, 20, 40, 80),
            new LeakSceneEntry("still-cup", _ => CupScenes.Still()),
            new LeakSceneEntry("funnel", _ => CupScenes.Funnel()),
            new LeakSceneEntry("bunny", _ => CupScenes.Bunny(false)),
            new LeakSceneEntry("bunny-turned", _ => CupScenes.Bunny(true)),
            new LeakSceneEntry("knife", JetScenes.Knife, 2, 10),
            new LeakSceneEntry("vertex", JetScenes.Vertex, 2, 10),
            new LeakSceneEntry("wall", JetScenes.Wall, 3),
            new LeakSceneEntry("sizes", SheetScenes.Sizes, 5),
            new LeakSceneEntry("coplanar", SheetScenes.Coplanar, 5),
            new LeakSceneEntry("two-sided", SheetScenes.TwoSided, 2),
            new LeakSceneEntry("pulse-10", s => StretchScenes.Pulse(0.1, s), StretchScenes.Speeds(0.1)),
            new LeakSceneEntry("pulse-25", s => StretchScenes.Pulse(0.25, s), StretchScenes.Speeds(0.25)),
            new LeakSceneEntry("pulse-50", s => StretchScenes.Pulse(0.5, s), StretchScenes.Speeds(0.5)),
            new LeakSceneEntry("uneven-25", s => StretchScenes.Uneven(0.25, s), StretchScenes.Speeds(0.25)),
            new LeakSceneEntry("uneven-50", s => StretchScenes.Uneven(0.5, s), StretchScenes.Speeds(0.5)),
            new LeakSceneEntry("spin", StretchScenes.Spin, 1, 2, 5, 10),
            new LeakSceneEntry("shear", StretchScenes.Shear, StretchScenes.Speeds(0.4)),
            new LeakSceneEntry("grow", StretchScenes.Grow, 0.2, 1),
            new LeakSceneEntry("afloat", BodyScenes.Afloat, 1, 2, 5, 10),
            new LeakSceneEntry("bumped", BodyScenes.Bumped, 1, 2, 5, 10),
            new LeakSceneEntry("waved", BodyScenes.Waved, 0.2, 0.5, 1, 2),
            new LeakSceneEntry("wrung", BodyScenes.Wrung, 0.5, 1, 2, 5),
            new LeakSceneEntry("wheel", BodyScenes.Wheel, 2, 10, 20),
            new LeakSceneEntry("pressed", BodyScenes.Pressed, 0.5, 2, 10),
        };

        /// <summary>The scene of a name.</summary>
        public static LeakSceneEntry Find(string name) => All.First(s => s.Name == name);

        /// <summary>The scene at a speed.</summary>
        public LeakScene Build(double speed)
        {
            LeakScene scene = build(speed);
            scene.Name = Name;
            scene.Speed = speed;
            return scene;
        }

        /// <summary>Constants for water.</summary>
        /// <param name="domain">Size of the domain [m].</param>
        /// <param name="height">Height that the liquid can fall from [m].</param>
        /// <param name="speed">Speed that it starts with [m/s].</param>
        public static FluidSolverSettings Water(Vector3 domain, float height, double speed = 0.0)
        {
            FluidRuleInput input = FluidRuleInput.Water;
            input.Method = FluidMethodKind.Standard;
            input.DomainSize = domain;
            input.Spacing = Spacing;
            input.LiquidHeight = height;
            input.LiquidDepth = height;
            input.InitialSpeed = (float)speed;
            return FluidRules.Derive(input);
        }
    }
}
