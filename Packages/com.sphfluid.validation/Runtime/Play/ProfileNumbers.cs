using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Validation
{
    /// <summary>
    /// Numbers of a profile that a command line gives, by their names in the Inspector: <c>support-ratio=2,substeps=2</c>.
    /// </summary>
    internal sealed class ProfileNumbers
    {
        private static readonly (string Name, Action<FluidProfile, float> Set, Func<FluidProfile, float> Get)[] known =
        {
            ("support-ratio", (p, v) => p.SupportRatio = v, p => p.SupportRatio),
            ("sound-speed-ratio", (p, v) => p.SoundSpeedRatio = v, p => p.SoundSpeedRatio),
            ("max-compression", (p, v) => p.MaxCompression = v, p => p.MaxCompression),
            ("time-step-fraction", (p, v) => p.TimeStepFraction = v, p => p.TimeStepFraction),
            ("viscosity-ratio", (p, v) => p.ViscosityRatio = v, p => p.ViscosityRatio),
            ("substeps", (p, v) => p.Substeps = Mathf.RoundToInt(v), p => p.Substeps),
        };

        private readonly string flag;
        private readonly List<(string Name, float Value)> numbers = new List<(string, float)>();

        private ProfileNumbers(string flag) => this.flag = flag;

        /// <summary>Names that are known.</summary>
        public static string[] Names => known.Select(k => k.Name).ToArray();

        /// <summary>Reads a list.</summary>
        /// <param name="flag">For messages.</param>
        /// <param name="text">Names and numbers, with commas between.</param>
        /// <exception cref="CommandLineException">A name is unknown or given twice, or what stands behind it is no number.</exception>
        public static ProfileNumbers Parse(string flag, string text)
        {
            var result = new ProfileNumbers(flag);
            foreach (string word in CommandLineWords.List(flag, text))
            {
                int equals = word.IndexOf('=');
                string name = equals < 0 ? word : word.Substring(0, equals).Trim();
                CommandLineWords.RequireOneOf(flag, name, Names);
                if (result.numbers.Any(n => n.Name == name)) throw new CommandLineException($"{flag} has {name} twice.");
                if (equals < 0) throw new CommandLineException($"{flag}: {name} needs a number, as in {name}=2.");
                result.numbers.Add((name, (float)CommandLineWords.Positive($"{flag}: {name}", word.Substring(equals + 1).Trim())));
            }
            return result;
        }

        /// <summary>Gives a liquid a profile of its own that has them, and leaves the asset as it is.</summary>
        /// <exception cref="CommandLineException">It has no profile, or a number is outside of the profile's range.</exception>
        public void Set(FluidSimulation simulation)
        {
            if (simulation.Profile == null)
            {
                throw new CommandLineException(
                    $"{flag}: '{simulation.name}' has no profile before it starts. Give it one, or a Liquid, in the scene.");
            }
            string asset = simulation.Profile.name;
            FluidProfile profile = Object.Instantiate(simulation.Profile);
            profile.name = asset;
            foreach ((string name, float value) in numbers)
            {
                var number = known.First(k => k.Name == name);
                number.Set(profile, value);
                float taken = number.Get(profile);
                if (taken != value)
                {
                    throw new CommandLineException(FormattableString.Invariant(
                        $"{flag}: {name} {value} is not a value that a profile may have; the nearest is {taken}."));
                }
            }
            simulation.Profile = profile;
        }
    }
}
