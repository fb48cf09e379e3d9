using System;
using System.Collections;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>
    /// Every number and choice of every component and asset, by its property and by the field that a scene file sets, is given what it
    /// should not be while a liquid runs. It is brought into the range that its field declares and its comment states; or one line names
    /// the object and the member, with a cure; or its setter throws. Frames go on, without an exception, and all particles keep numbers.
    /// What is in the list is found by reflection: a new member needs no line here.
    /// </summary>
    public abstract class SettingsContract
    {
        private static readonly Regex RangeWords =
            new Regex(@"\d[^.;]* to [<\d]|or more|or less|at least|at most|greater than|more than|above|positive|between|counts? (as|for)",
                RegexOptions.IgnoreCase);

        // Names of lengths and amounts that nothing can have less than none of.
        private static readonly Regex NeverNegative = new Regex("Size$|Radius$|Spacing$|Mass$|Length$");

        private readonly List<string> failures = new List<string>();
        private ContractLiquid liquid;
        private object root;
        private int tried;

        /// <summary>A liquid that runs.</summary>
        protected FluidSimulation Simulation => liquid.Simulation;

        [SetUp]
        public void SetUp()
        {
            failures.Clear();
            tried = 0;
            liquid = new ContractLiquid();
        }

        [TearDown]
        public void TearDown()
        {
            liquid.Dispose();
        }

        /// <summary>Components and assets of a package that have numbers or choices.</summary>
        protected static IEnumerable<Type> RootsOf(Assembly package) =>
            package.GetExportedTypes().Where(t => !t.IsAbstract && typeof(Object).IsAssignableFrom(t) && PublicInput.Of(t).Count > 0);

        /// <summary>Gives every number and choice of a component or asset what it should not be.</summary>
        protected IEnumerator TryAll(Type type)
        {
            root = Make(type);
            yield return null;
            foreach (PublicInput input in PublicInput.Of(type))
            {
                object good = input.Get(root);
                foreach (object bad in BadValues.Of(input.Type, good))
                {
                    IEnumerator trial = Try(input, good, bad);
                    while (trial.MoveNext()) yield return trial.Current;
                }
            }
            Assert.That(failures, Is.Empty, $"{failures.Count} of {tried}\n" + string.Join("\n", failures));
        }

        private IEnumerator Try(PublicInput input, object good, object bad)
        {
            tried++;
            liquid.Listen();
            string what = $"{root.GetType().Name}.{input.Name} = {BadValues.Text(bad)}";
            try
            {
                input.Set(root, bad);
                Judge(what, input, bad, input.Get(root));
            }
            catch (ArgumentException exception)
            {
                if (exception.ParamName != "value") failures.Add($"MISNAMED {what}: throws about '{exception.ParamName}'");
            }
            catch (Exception exception)
            {
                failures.Add($"EXCEPTION {what}: {exception.GetType().Name} {exception.Message}");
            }
            if (input.IsStored)
            {
                tried++;
                input.Store(root, bad);
            }
            IEnumerator frames = Run(what, input, bad);
            while (frames.MoveNext()) yield return frames.Current;
            try
            {
                if (input.IsStored) input.Store(root, good);
                input.Set(root, good);
            }
            catch (Exception exception)
            {
                failures.Add($"EXCEPTION {what}, then its good value again: {exception.GetType().Name} {exception.Message}");
            }
            bool goesOn = false;
            IEnumerator after = liquid.GoOn(on => goesOn = on);
            while (after.MoveNext()) yield return after.Current;
            if (!goesOn) failures.Add($"STUCK {what}: no frame after its good value was set again. {liquid.Simulation.StatusMessage}");
            if (!goesOn || liquid.IsDamaged) liquid.Simulation.StartSimulation();
        }

        // Another value than the bad one is one in its range, and the range is stated.
        private void Judge(string what, PublicInput input, object bad, object shown)
        {
            if (BadValues.Same(shown, bad)) return;
            if (IsFault(input, shown)) failures.Add($"RANGE {what}: shows {BadValues.Text(shown)}, which is out of its own range");
            bool isChoice = BadValues.PartsOf(bad).First() is Enum; // the manual states the rule for all of them
            if (!isChoice && !RangeWords.IsMatch(input.Tooltip + " " + PublicComments.Of(input.Declaring, input.Label)))
            {
                failures.Add($"UNDOCUMENTED {what}: shows {BadValues.Text(shown)}, and neither comment nor tooltip states a range");
            }
        }

        private static bool IsFault(PublicInput input, object value)
        {
            (double least, double most) = BadValues.RangeOf(value);
            (double from, double to) = input.Declared;
            if (NeverNegative.IsMatch(input.Label)) from = Math.Max(from, 0.0);
            return !BadValues.IsUsable(value) || least < from || most > to;
        }

        // A member that only some choices read is told of under these.
        private IEnumerator Run(string what, PublicInput input, object bad)
        {
            IEnumerator frames = Frame(what);
            while (frames.MoveNext()) yield return frames.Current;
            if (!liquid.Simulation.IsRunning && !IsTold(input)) failures.Add($"MISNAMED {what}: {liquid.Simulation.StatusMessage}");
            if (input.IsStored) Judge(what + " in a file", input, bad, input.Get(root));
            if (!BadValues.Same(input.Get(root), bad) || !IsFault(input, bad) || IsTold(input)) yield break;
            foreach ((PropertyInfo choice, object value) in Choices(root.GetType()))
            {
                object before = choice.GetValue(root);
                if (choice.Name == input.Name || Equals(before, value)) continue;
                choice.SetValue(root, value);
                frames = Frame($"{what} with {choice.Name} = {value}");
                while (frames.MoveNext()) yield return frames.Current;
                choice.SetValue(root, before);
                if (IsTold(input)) yield break;
            }
            string said = string.Join(" / ", liquid.Said.Distinct().Take(2));
            failures.Add(said.Length == 0 ? $"SILENT {what}" : $"MISNAMED {what}: {said}");
        }

        private IEnumerator Frame(string what)
        {
            yield return null;
            if (root is FluidVolume) liquid.Simulation.StartSimulation(); // which reads it then
            yield return null;
            if (liquid.Exception != null) failures.Add($"EXCEPTION {what}: {liquid.Exception}");
            if (liquid.IsDamaged) failures.Add($"DAMAGE {what}");
            if (!liquid.Simulation.IsRunning && !FluidSimulationChecks.HasErrors(liquid.Simulation.Messages))
            {
                failures.Add($"STOPPED {what}: without an error");
            }
            if (liquid.Exception != null || liquid.IsDamaged) liquid.Simulation.StartSimulation();
        }

        private bool IsTold(PublicInput input)
        {
            var named = new Regex(Regex.Replace(input.Label, "(?<=[a-z])(?=[A-Z])", " ?"), RegexOptions.IgnoreCase);
            string owner = ((Object)root).name;
            return liquid.Said.Any(line => line.Contains($"'{owner}'") && named.IsMatch(line.Replace($"'{owner}'", "")) &&
                Regex.IsMatch(line, @"\. [A-Z]"));
        }

        private static IEnumerable<(PropertyInfo, object)> Choices(Type type)
        {
            foreach (PropertyInfo property in type.GetProperties())
            {
                if (property.GetSetMethod() == null || !PublicCalls.IsOurs(property.DeclaringType)) continue;
                if (property.PropertyType == typeof(bool)) foreach (bool value in new[] { true, false }) yield return (property, value);
                else if (property.PropertyType.IsEnum &&
                    property.PropertyType !=
                        typeof(SurfaceGridSize)) foreach (object value in Enum.GetValues(property.PropertyType)) yield return (property,
                            value);
            }
        }

        /// <summary>A component or asset that is set up as one that works.</summary>
        protected virtual object Make(Type type)
        {
            FluidSimulation simulation = liquid.Simulation;
            if (type == typeof(FluidSimulation)) return simulation;
            if (type == typeof(FluidProfile)) return liquid.Rig.Profile;
            if (type == typeof(FluidVolume)) return simulation.GetComponentInChildren<FluidVolume>();
            if (typeof(ScriptableObject).IsAssignableFrom(type)) return ScriptableObject.CreateInstance(type);
            bool isBeside = typeof(FluidView).IsAssignableFrom(type) ||
                type.GetCustomAttributes<RequireComponent>().Any(r => r.m_Type0 == typeof(FluidSimulation));
            GameObject holder = isBeside ? simulation.gameObject : liquid.Rig.NewObject("Subject");
            if (!isBeside) holder.transform.SetParent(simulation.transform, false);
            holder.transform.localPosition = isBeside ? Vector3.zero : new Vector3(0f, 0.15f, 0f);
            Component made = holder.AddComponent(type);
            if (made is FluidCollider) holder.AddComponent<BoxCollider>().size = 0.05f * Vector3.one;
            if (made is FluidGeometrySurfaceRenderer thesis) thesis.GridSize = SurfaceGridSize.Cells32;
            return made;
        }
    }

    /// <summary>Comments of the packages' source.</summary>
    internal static class PublicComments
    {
        private static readonly Dictionary<string, string> Sources = new Dictionary<string, string>();

        /// <summary>The comment of a member; where the source is not there, as in a test player, whatever is asked for.</summary>
        public static string Of(Type type, string member)
        {
            if (!Sources.TryGetValue(type.Name, out string source))
            {
                string[] files = Directory.Exists("Packages")
                    ? Directory.GetFiles("Packages", type.Name + ".cs", SearchOption.AllDirectories) : new string[0];
                Sources.Add(type.Name, source = files.Length == 0 ? null : File.ReadAllText(files[0]));
            }
            if (source == null) return "0 to 1";
            return Regex.Match(source, $@"((?:^\s*///.*\n)*)(?:^\s*\[.*\n)*^\s*public [^(=;]*\b{member}\b",
                RegexOptions.Multiline).Groups[1].Value;
        }
    }
}
